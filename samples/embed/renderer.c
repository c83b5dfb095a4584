/* renderer.c - a picture, from the camera's rays to the sum of all bounces: nothing waits for the
 * device before the end. */
#include "renderer.h"

#include <stdio.h>
#include <stdlib.h>

/* From now on the next command waits for this one alone. */
static void follow(renderer* r, cl_event done) {
    for (cl_uint i = 0; i < r->wait_count; ++i) clReleaseEvent(r->waits[i]);
    r->waits[0] = done;
    r->wait_count = 1;
}

static const cl_event* wait_list(const renderer* r) {
    return r->wait_count ? r->waits : NULL;
}

#define ENQUEUE(call, desc)                                                                  \
    do {                                                                                     \
        cl_event done;                                                                       \
        require(call(r->rsh, r->queue, &(desc), r->wait_count, wait_list(r), &done), #call); \
        follow(r, done);                                                                     \
    } while (0)

/* NULL: a screen has all its rays. */
static cl_mem list_count(const wave* w) {
    return w->height > 1 ? NULL : w->count;
}

/* Of the camera's rays, 1. */
static cl_mem weights_of(const renderer* r, const wave* w) {
    return w == r->waves ? NULL : w->weights;
}

void move_vertices(renderer* r, const scene_arrays* scene) {
    cl_event done;
    require(clEnqueueWriteBuffer(r->queue, r->vertices, CL_FALSE, 0,
                                 scene->vertex_count * 6 * sizeof(cl_float), scene->vertices,
                                 r->wait_count, wait_list(r), &done),
            "clEnqueueWriteBuffer");
    follow(r, done);
}

/* The scene's bounds and what the camera sees, side by side: neither waits for the other. */
static void see(renderer* r) {
    rsh_bound_desc bound = {.struct_size = sizeof bound, .geometry = r->scene.geometry};
    bound.bounds = r->bounds;
    cl_event bounded;
    require(rsh_bound(r->rsh, r->queue, &bound, r->wait_count, wait_list(r), &bounded),
            "rsh_bound");
    const wave* w = r->waves;
    rsh_rasterize_desc desc = {.struct_size = sizeof desc, .geometry = r->scene.geometry};
    desc.camera = r->camera;
    desc.width = w->width;
    desc.height = w->height;
    desc.rays = w->rays;
    desc.hits = w->hits;
    ENQUEUE(rsh_rasterize, desc);
    r->waits[r->wait_count++] = bounded;
}

static void trace(renderer* r, const wave* w) {
    rsh_build_desc build = {.struct_size = sizeof build, .rays = w->rays};
    build.width = w->width;
    build.height = w->height;
    build.list_count = list_count(w);
    build.nodes = r->nodes;
    ENQUEUE(rsh_build, build);
    rsh_traverse_desc desc = {.struct_size = sizeof desc, .geometry = r->scene.geometry};
    desc.bounds = r->bounds;
    desc.rays = w->rays;
    desc.nodes = r->nodes;
    desc.width = w->width;
    desc.height = w->height;
    desc.hits = w->hits;
    desc.skip = w->skip;
    desc.list_count = list_count(w);
    ENQUEUE(rsh_traverse, desc);
}

static void find_shadows(renderer* r, const wave* w) {
    rsh_shadow_desc shadow = {.struct_size = sizeof shadow, .scene = &r->scene};
    shadow.width = w->width;
    shadow.height = w->height;
    shadow.rays = w->rays;
    shadow.hits = w->hits;
    shadow.bounds = r->bounds;
    shadow.occlusion = r->occlusion;
    shadow.list_count = list_count(w);
    ENQUEUE(rsh_shadow, shadow);
}

static void shade(renderer* r, const wave* w) {
    const cl_uint most = w->width * w->height, lights = LIGHTS;
    const cl_mem count = list_count(w), weights = weights_of(r, w);
    const struct {
        size_t bytes;
        const void* value;
    } arguments[] = {{sizeof most, &most},
                     {sizeof count, &count},
                     {sizeof r->vertices, &r->vertices},
                     {sizeof r->indices, &r->indices},
                     {sizeof r->material_ids, &r->material_ids},
                     {sizeof w->rays, &w->rays},
                     {sizeof w->hits, &w->hits},
                     {sizeof weights, &weights},
                     {sizeof r->occlusion, &r->occlusion},
                     {sizeof r->materials, &r->materials},
                     {sizeof r->lights, &r->lights},
                     {sizeof lights, &lights},
                     {sizeof r->scene.ambient, &r->scene.ambient},
                     {sizeof r->scene.environment, &r->scene.environment},
                     {sizeof w->colour, &w->colour}};
    for (cl_uint i = 0; i < sizeof arguments / sizeof *arguments; ++i)
        require(clSetKernelArg(r->kernel, i, arguments[i].bytes, arguments[i].value),
                "clSetKernelArg");
    const size_t group = 64, items = (most + group - 1) / group * group;
    cl_event done;
    require(clEnqueueNDRangeKernel(r->queue, r->kernel, 1, NULL, &items, &group, r->wait_count,
                                   wait_list(r), &done),
            "clEnqueueNDRangeKernel");
    follow(r, done);
}

static void spawn(renderer* r, const wave* w, const wave* next) {
    rsh_spawn_wave_desc desc = {.struct_size = sizeof desc, .scene = &r->scene};
    desc.width = w->width;
    desc.height = w->height;
    desc.rays = w->rays;
    desc.hits = w->hits;
    desc.weights = weights_of(r, w);
    desc.capacity = next->width;
    desc.branches = w->branches;
    desc.spawned_rays = next->rays;
    desc.spawned_weights = next->weights;
    desc.spawned_skip = next->skip;
    desc.spawned_count = next->count;
    desc.list_count = list_count(w);
    ENQUEUE(rsh_spawn_wave, desc);
}

static void gather(renderer* r, const wave* w, const wave* next) {
    rsh_gather_wave_desc desc = {.struct_size = sizeof desc, .scene = &r->scene};
    desc.width = w->width;
    desc.height = w->height;
    desc.capacity = next->width;
    desc.branches = w->branches;
    desc.spawned_count = next->count;
    desc.spawned_colour = next->colour;
    desc.colour = w->colour;
    desc.list_count = list_count(w);
    ENQUEUE(rsh_gather_wave, desc);
}

static void read_count(renderer* r, int bounce) {
    cl_event done;
    require(clEnqueueReadBuffer(r->queue, r->waves[bounce].count, CL_FALSE, 0,
                                sizeof r->counts[bounce], r->counts[bounce], r->wait_count,
                                wait_list(r), &done),
            "clEnqueueReadBuffer");
    follow(r, done);
}

void render(renderer* r) {
    wave* const waves = r->waves;
    see(r);
    for (int bounce = 0; bounce <= BOUNCES; ++bounce) {
        if (bounce > 0) trace(r, &waves[bounce]);
        find_shadows(r, &waves[bounce]);
        shade(r, &waves[bounce]);
        if (bounce < BOUNCES) spawn(r, &waves[bounce], &waves[bounce + 1]);
    }
    for (int bounce = BOUNCES; bounce-- > 0;) gather(r, &waves[bounce], &waves[bounce + 1]);
    for (int bounce = 1; bounce <= BOUNCES; ++bounce) read_count(r, bounce);
}

void finish(renderer* r) {
    if (r->wait_count) require(clWaitForEvents(r->wait_count, r->waits), "clWaitForEvents");
    for (cl_uint i = 0; i < r->wait_count; ++i) clReleaseEvent(r->waits[i]);
    r->wait_count = 0;
    for (int bounce = 1; bounce <= BOUNCES; ++bounce)
        if (r->counts[bounce][1] > r->waves[bounce].width) {
            fprintf(stderr, "bounce %d: has %u rays, room for %u\n", bounce,
                    r->counts[bounce][1], r->waves[bounce].width);
            exit(EXIT_FAILURE);
        }
}
