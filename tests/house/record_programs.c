/* record_programs.c - preloaded into a program that uses rsh, writes every OpenCL program that is
 * built from source into the folder that RSH_RECORD_PROGRAMS names: a line with the options, then
 * the source as the library puts it together. One file for each pair of options and source. */
#define _GNU_SOURCE
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <dlfcn.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef cl_program (*create_function)(cl_context, cl_uint, const char**, const size_t*,
                                      cl_int*);
typedef cl_program (*load_function)(cl_context, cl_uint, const cl_device_id*, const size_t*,
                                    const unsigned char**, cl_int*, cl_int*);
typedef cl_int (*build_function)(cl_program, cl_uint, const cl_device_id*, const char*,
                                 void(CL_CALLBACK*)(cl_program, void*), void*);

typedef struct recorded {
    cl_program program;
    char* source; /* NULL: of a binary */
    struct recorded* next;
} recorded;

static recorded* programs;
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;

/* POSIX promises that a function pointer fits; ISO C has no cast for it. */
static void find_next(const char* name, void* function) {
    void* const found = dlsym(RTLD_NEXT, name);
    if (!found) {
        fprintf(stderr, "record_programs: there is no %s\n", name);
        abort();
    }
    memcpy(function, &found, sizeof found);
}

static char* joined(cl_uint count, const char** strings, const size_t* lengths) {
    size_t size = 0;
    char* text = calloc(1, 1);
    for (cl_uint i = 0; i < count; ++i) {
        const size_t length = lengths && lengths[i] ? lengths[i] : strlen(strings[i]);
        text = realloc(text, size + length + 1);
        memcpy(text + size, strings[i], length);
        size += length;
        text[size] = 0;
    }
    return text;
}

/* The last one counts: a handle is used again after its program was released. */
static const char* source_of(cl_program program) {
    for (const recorded* p = programs; p; p = p->next)
        if (p->program == program) return p->source;
    return NULL;
}

static uint64_t fnv1a(uint64_t hash, const char* text) {
    for (; *text; ++text) hash = (hash ^ (unsigned char)*text) * 0x100000001b3u;
    return hash;
}

/* Under another name first, as processes that run side by side build the same programs. */
static void write_program(const char* folder, const char* options, const char* source) {
    char path[4096], temporary[4200];
    const uint64_t hash = fnv1a(fnv1a(0xcbf29ce484222325u, options), source);
    snprintf(path, sizeof path, "%s/%016llx.cl", folder, (unsigned long long)hash);
    snprintf(temporary, sizeof temporary, "%s.%d", path, (int)getpid());
    FILE* const file = fopen(temporary, "w");
    if (!file || fprintf(file, "// %s\n%s", options, source) < 0 || fclose(file) != 0 ||
        rename(temporary, path) != 0) {
        fprintf(stderr, "record_programs: cannot write %s\n", path);
        abort();
    }
}

static void remember(cl_program program, char* source) {
    recorded* const made = malloc(sizeof *made);
    made->program = program;
    made->source = source;
    pthread_mutex_lock(&mutex);
    made->next = programs;
    programs = made;
    pthread_mutex_unlock(&mutex);
}

cl_program clCreateProgramWithSource(cl_context context, cl_uint count, const char** strings,
                                     const size_t* lengths, cl_int* status) {
    create_function next;
    find_next("clCreateProgramWithSource", &next);
    const cl_program program = next(context, count, strings, lengths, status);
    if (program) remember(program, joined(count, strings, lengths));
    return program;
}

/* It may get the handle of a program that had a source. */
cl_program clCreateProgramWithBinary(cl_context context, cl_uint device_count,
                                     const cl_device_id* devices, const size_t* lengths,
                                     const unsigned char** binaries, cl_int* binary_status,
                                     cl_int* status) {
    load_function next;
    find_next("clCreateProgramWithBinary", &next);
    const cl_program program =
        next(context, device_count, devices, lengths, binaries, binary_status, status);
    if (program) remember(program, NULL);
    return program;
}

cl_int clBuildProgram(cl_program program, cl_uint device_count, const cl_device_id* devices,
                      const char* options, void(CL_CALLBACK* notify)(cl_program, void*),
                      void* user_data) {
    build_function next;
    find_next("clBuildProgram", &next);
    const char* const folder = getenv("RSH_RECORD_PROGRAMS");
    pthread_mutex_lock(&mutex);
    const char* const source = source_of(program);
    if (folder && source) write_program(folder, options ? options : "", source);
    pthread_mutex_unlock(&mutex);
    return next(program, device_count, devices, options, notify, user_data);
}
