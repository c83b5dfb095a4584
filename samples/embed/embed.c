/* embed.c - rsh in a renderer that has a context, memory and a shading kernel of its own.
 *
 *   rsh-embed [--size W H] [--frames N] [--out FILE.ppm] [--compare]
 *
 * Renders N frames of a moving scene, writes the last one, and prints milliseconds per frame. --compare:
 * renders the scene at rest N times, and each time with rsh_frame as well; prints both times' medians,
 * their ratio and the largest difference of 8-bit channels, and fails where that is above 2.
 */
#define _POSIX_C_SOURCE 199309L /* clock_gettime */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "renderer.h"

#define MOST_DIFFERENCE 2

typedef struct options {
    cl_uint width, height;
    int frames, compares;
    const char* out;
} options;

static options read_options(int argc, char** argv) {
    options o = {640, 480, 1, 0, NULL};
    for (int i = 1; i < argc; ++i) {
        const int left = argc - 1 - i;
        if (!strcmp(argv[i], "--compare")) {
            o.compares = 1;
        } else if (!strcmp(argv[i], "--frames") && left >= 1) {
            o.frames = atoi(argv[++i]);
        } else if (!strcmp(argv[i], "--out") && left >= 1) {
            o.out = argv[++i];
        } else if (!strcmp(argv[i], "--size") && left >= 2) {
            o.width = (cl_uint)strtoul(argv[++i], NULL, 10);
            o.height = (cl_uint)strtoul(argv[++i], NULL, 10);
        } else {
            fprintf(stderr, "%s: is no option, or its value is missing\n", argv[i]);
            exit(EXIT_FAILURE);
        }
    }
    if (o.frames < 1 || o.width < 2 || o.height < 2 || o.width > 4096 || o.height > 4096) {
        fprintf(stderr, "--frames: must be at least 1; --size: 2 .. 4096 each\n");
        exit(EXIT_FAILURE);
    }
    return o;
}

static double now_ms(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e3 * (double)now.tv_sec + 1e-6 * (double)now.tv_nsec;
}

static int compare_doubles(const void* a, const void* b) {
    const double x = *(const double*)a, y = *(const double*)b;
    return (x > y) - (x < y);
}

static double median(double* values, int count) {
    qsort(values, (size_t)count, sizeof *values, compare_doubles);
    return values[count / 2];
}

static unsigned char to_srgb8(float linear) {
    const float c = fminf(fmaxf(linear, 0), 1);
    const float s = c <= 0.0031308f ? 12.92f * c : 1.055f * powf(c, 1 / 2.4f) - 0.055f;
    return (unsigned char)(255 * s + 0.5f);
}

/* Three bytes per pixel; to be freed. */
static unsigned char* read_picture(renderer* r, cl_mem colour, size_t pixels) {
    rsh_float4* linear = malloc(pixels * sizeof *linear);
    unsigned char* bytes = malloc(3 * pixels);
    if (!linear || !bytes) exit(EXIT_FAILURE);
    require(clEnqueueReadBuffer(r->queue, colour, CL_TRUE, 0, pixels * sizeof *linear, linear,
                                0, NULL, NULL),
            "clEnqueueReadBuffer");
    for (size_t i = 0; i < 3 * pixels; ++i) bytes[i] = to_srgb8(linear[i / 3].s[i % 3]);
    free(linear);
    return bytes;
}

static void write_ppm(const char* path, const unsigned char* bytes, const options* o) {
    const size_t count = 3 * (size_t)o->width * o->height;
    FILE* file = fopen(path, "wb");
    int is_written = file && fprintf(file, "P6\n%u %u\n255\n", o->width, o->height) > 0 &&
                     fwrite(bytes, 1, count, file) == count;
    if (file && fclose(file) != 0) is_written = 0;
    if (is_written) return;
    fprintf(stderr, "%s: cannot be written\n", path);
    exit(EXIT_FAILURE);
}

static double render_once(renderer* r) {
    const double start = now_ms();
    render(r);
    finish(r);
    return now_ms() - start;
}

static double render_reference(renderer* r, const options* o, cl_mem colour) {
    rsh_frame_desc desc = {.struct_size = sizeof desc, .scene = &r->scene, .camera = r->camera};
    desc.width = o->width;
    desc.height = o->height;
    desc.bounces = BOUNCES;
    desc.colour = colour;
    cl_event done;
    const double start = now_ms();
    require(rsh_frame(r->rsh, r->queue, &desc, 0, NULL, &done), "rsh_frame");
    require(clWaitForEvents(1, &done), "clWaitForEvents");
    clReleaseEvent(done);
    return now_ms() - start;
}

/* The first round of each compiles, and is not counted. */
static int compare(renderer* r, const options* o) {
    const size_t pixels = (size_t)o->width * o->height;
    double* own = malloc((size_t)o->frames * sizeof *own);
    double* reference = malloc((size_t)o->frames * sizeof *reference);
    cl_int status;
    cl_mem colour = clCreateBuffer(r->context, CL_MEM_READ_WRITE, pixels * sizeof(rsh_float4),
                                   NULL, &status);
    require(status, "clCreateBuffer");
    if (!own || !reference) exit(EXIT_FAILURE);
    for (int i = -1; i < o->frames; ++i) {
        const double first = render_once(r), second = render_reference(r, o, colour);
        if (i >= 0) own[i] = first, reference[i] = second;
    }
    unsigned char* mine = read_picture(r, r->waves[0].colour, pixels);
    unsigned char* theirs = read_picture(r, colour, pixels);
    int most = 0;
    for (size_t i = 0; i < 3 * pixels; ++i) most = (int)fmax(most, abs(mine[i] - theirs[i]));
    const double own_ms = median(own, o->frames), reference_ms = median(reference, o->frames);
    printf("own %.2f ms, rsh_frame %.2f ms, ratio %.3f; channels differ by %d at most\n",
           own_ms, reference_ms, own_ms / reference_ms, most);
    clReleaseMemObject(colour);
    free(own);
    free(reference);
    free(mine);
    free(theirs);
    return most <= MOST_DIFFERENCE;
}

int main(int argc, char** argv) {
    const options o = read_options(argc, argv);
    scene_arrays scene = make_scene();
    renderer r;
    make_renderer(&r, &scene, o.width, o.height);
    int is_right = 1;
    if (o.compares) {
        is_right = compare(&r, &o);
    } else {
        for (int i = 0; i < o.frames; ++i) {
            place_scene(&scene, 0.05f * (float)i);
            move_vertices(&r, &scene);
            printf("frame %d: %.2f ms\n", i, render_once(&r));
        }
    }
    if (o.out) {
        unsigned char* bytes = read_picture(&r, r.waves[0].colour, (size_t)o.width * o.height);
        write_ppm(o.out, bytes, &o);
        free(bytes);
    }
    free_renderer(&r);
    free_scene(&scene);
    return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
