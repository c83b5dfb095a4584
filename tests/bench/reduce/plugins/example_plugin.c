/* example_plugin.c - a plug-in for rsh-bench reduce: each kept element takes the next place by an atomic
 * counter, so that it does not keep the order. */
#include <stdio.h>
#include <stdlib.h>

#include "rsh_bench_plugin.h"

typedef struct example {
    rsh_bench_stream stream;
    cl_program program;
    cl_kernel kernel;
} example;

static cl_int status; /* of the first call that failed */

static const char kSource[] =
    "kernel void reduce(global const uint* from, global uint* to, global uint* count) {\n"
    "    const size_t i = get_global_id(0);\n"
    "    if (from[i * WORDS] == 0xffffffffu) return;\n"
    "    const uint at = atomic_inc(count);\n"
    "    for (uint w = 0; w < WORDS; ++w) to[at * WORDS + w] = from[i * WORDS + w];\n"
    "}\n";

static void destroy(void* state) {
    example* e = state;
    if (e->kernel) clReleaseKernel(e->kernel);
    if (e->program) clReleaseProgram(e->program);
    free(e);
}

static int create(const rsh_bench_stream* stream, void** state) {
    const char* source = kSource;
    char options[32];
    example* e = calloc(1, sizeof *e);
    status = CL_SUCCESS;
    if (stream->keep != RSH_BENCH_KEEP_NOT_NULL) return free(e), RSH_BENCH_REFUSED;
    if (!e) return status = CL_OUT_OF_HOST_MEMORY;
    e->stream = *stream;
    snprintf(options, sizeof options, "-DWORDS=%u", (unsigned)(stream->element_bytes / 4));
    e->program = clCreateProgramWithSource(stream->context, 1, &source, NULL, &status);
    if (!status) status = clBuildProgram(e->program, 1, &stream->device, options, NULL, NULL);
    if (!status) e->kernel = clCreateKernel(e->program, "reduce", &status);
    if (!status) status = clSetKernelArg(e->kernel, 0, sizeof(cl_mem), &stream->input);
    if (!status) status = clSetKernelArg(e->kernel, 1, sizeof(cl_mem), &stream->output);
    if (!status) status = clSetKernelArg(e->kernel, 2, sizeof(cl_mem), &stream->output_count);
    if (status) return destroy(e), status;
    *state = e;
    return RSH_BENCH_DONE;
}

static int run(void* state) {
    const example* e = state;
    const cl_uint zero = 0;
    const size_t items = e->stream.count;
    status = clEnqueueFillBuffer(e->stream.queue, e->stream.output_count, &zero, sizeof zero, 0,
                                 sizeof zero, 0, NULL, NULL);
    if (!status)
        status = clEnqueueNDRangeKernel(e->stream.queue, e->kernel, 1, NULL, &items, NULL, 0,
                                        NULL, NULL);
    return status;
}

static const char* error(void) {
    static char text[48];
    snprintf(text, sizeof text, status ? "OpenCL error %d" : "takes not_null alone",
             (int)status);
    return text;
}

const rsh_bench_plugin* rsh_bench_get_plugin(void) {
    static const rsh_bench_plugin plugin = {
        RSH_BENCH_PLUGIN_VERSION, "example", CL_FALSE, create, run, destroy, error};
    return &plugin;
}
