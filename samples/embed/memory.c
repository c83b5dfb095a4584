/* memory.c - the renderer's objects of OpenCL: context, queue, kernel, and one buffer that all others
 * are parts of. */
#include <stdio.h>
#include <stdlib.h>

#include "embedded.h"
#include "renderer.h"

void require(cl_int status, const char* call) {
    if (status == RSH_SUCCESS) return;
    fprintf(stderr, "%s: %s: %s\n", call, rsh_status_string(status), rsh_last_error());
    exit(EXIT_FAILURE);
}

/* The next part of the arena; before there is one, only its size grows. */
static cl_mem take(renderer* r, size_t bytes) {
    const cl_buffer_region region = {r->used, bytes};
    r->used += (bytes + r->alignment - 1) / r->alignment * r->alignment;
    if (!r->arena) return NULL;
    cl_int status;
    cl_mem part = clCreateSubBuffer(r->arena, CL_MEM_READ_WRITE, CL_BUFFER_CREATE_TYPE_REGION,
                                    &region, &status);
    require(status, "clCreateSubBuffer");
    return part;
}

static cl_mem take_filled(renderer* r, size_t bytes, const void* contents) {
    cl_mem part = take(r, bytes);
    if (part)
        require(
            clEnqueueWriteBuffer(r->queue, part, CL_TRUE, 0, bytes, contents, 0, NULL, NULL),
            "clEnqueueWriteBuffer");
    return part;
}

static void take_wave(renderer* r, wave* w) {
    const size_t rays = (size_t)w->width * w->height;
    w->rays = take(r, rays * sizeof(rsh_ray));
    w->hits = take(r, rays * sizeof(rsh_hit));
    w->weights = take(r, rays * sizeof(rsh_float4));
    w->skip = take(r, rays * sizeof(cl_uint));
    w->colour = take(r, rays * sizeof(rsh_float4));
    w->branches = take(r, rays * 2 * sizeof(cl_uint));
    w->count = take(r, 2 * sizeof(cl_uint));
}

static size_t bytes_of_bounds(renderer* r) {
    rsh_bound_desc desc = {.struct_size = sizeof desc, .geometry = r->scene.geometry};
    rsh_sizes sizes = {.struct_size = sizeof sizes};
    require(rsh_bound_query(r->rsh, &desc, &sizes), "rsh_bound_query");
    return sizes.output_bytes;
}

static size_t bytes_of_nodes(renderer* r, const wave* w) {
    rsh_build_desc desc = {.struct_size = sizeof desc, .width = w->width, .height = w->height};
    rsh_sizes sizes = {.struct_size = sizeof sizes};
    require(rsh_build_query(r->rsh, &desc, &sizes), "rsh_build_query");
    return sizes.output_bytes;
}

static void take_all(renderer* r, const scene_arrays* scene) {
    const size_t pixels = (size_t)r->waves[0].width * r->waves[0].height;
    const size_t triangles = scene->triangle_count;
    r->used = 0;
    r->vertices = take_filled(r, scene->vertex_count * 6 * sizeof(cl_float), scene->vertices);
    r->indices = take_filled(r, triangles * 3 * sizeof(cl_uint), scene->indices);
    r->material_ids = take_filled(r, triangles * sizeof(cl_uint), scene->material_ids);
    r->materials = take_filled(r, sizeof scene->materials, scene->materials);
    r->lights = take_filled(r, sizeof scene->lights, scene->lights);
    r->bounds = take(r, bytes_of_bounds(r));
    r->nodes = take(r, bytes_of_nodes(r, &r->waves[1]));
    r->occlusion = take(r, pixels * sizeof(cl_uint));
    for (int bounce = 0; bounce <= BOUNCES; ++bounce) take_wave(r, &r->waves[bounce]);
}

static void make_arena(renderer* r, const scene_arrays* scene) {
    cl_int status;
    take_all(r, scene);
    r->arena = clCreateBuffer(r->context, CL_MEM_READ_WRITE, r->used, NULL, &status);
    require(status, "clCreateBuffer");
    take_all(r, scene);
}

static void describe_scene(renderer* r, const scene_arrays* scene) {
    rsh_scene* s = &r->scene;
    s->geometry.vertices = s->normals = r->vertices;
    s->geometry.indices = r->indices;
    s->material_ids = r->material_ids;
    s->materials = r->materials;
    s->lights = r->lights;
    require(rsh_find_features(s, scene->materials, scene->lights), "rsh_find_features");
}

static void make_kernel(renderer* r) {
    const char* const texts[] = {TYPES_TEXT, SHADE_TEXT};
    cl_int status;
    r->program = clCreateProgramWithSource(r->context, 2, (const char**)texts, NULL, &status);
    require(status, "clCreateProgramWithSource");
    require(clBuildProgram(r->program, 1, &r->device, "", NULL, NULL), "clBuildProgram");
    r->kernel = clCreateKernel(r->program, "shade", &status);
    require(status, "clCreateKernel");
}

static void make_context(renderer* r) {
    cl_platform_id platform;
    cl_int status;
    require(rsh_find_device(NULL, &platform, &r->device), "rsh_find_device");
    r->context = clCreateContext(NULL, 1, &r->device, NULL, NULL, &status);
    require(status, "clCreateContext");
    r->queue = clCreateCommandQueue(r->context, r->device,
                                    CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE, &status);
    require(status, "clCreateCommandQueue (out of order)");
    rsh_context_desc desc = {.struct_size = sizeof desc};
    desc.context = r->context;
    desc.device = r->device;
    require(rsh_create_context(&desc, &r->rsh), "rsh_create_context");
    cl_uint bits;
    require(clGetDeviceInfo(r->device, CL_DEVICE_MEM_BASE_ADDR_ALIGN, sizeof bits, &bits, NULL),
            "clGetDeviceInfo");
    r->alignment = bits / 8;
}

void make_renderer(renderer* r, const scene_arrays* scene, cl_uint width, cl_uint height) {
    static const renderer none;
    *r = none;
    make_context(r);
    make_kernel(r);
    r->waves[0].width = width;
    r->waves[0].height = height;
    for (int bounce = 1; bounce <= BOUNCES; ++bounce) {
        r->waves[bounce].width = width * height;
        r->waves[bounce].height = 1;
    }
    r->scene.struct_size = sizeof r->scene;
    r->scene.geometry.vertex_count = scene->vertex_count;
    r->scene.geometry.triangle_count = scene->triangle_count;
    r->scene.geometry.vertex_stride = r->scene.normal_stride = 6 * sizeof(cl_float);
    r->scene.normals_offset = 3 * sizeof(cl_float);
    r->scene.material_count = MATERIALS;
    r->scene.light_count = LIGHTS;
    r->scene.ambient = (rsh_float4){{0.15f, 0.15f, 0.18f, 0}};
    r->scene.environment = (rsh_float4){{0.35f, 0.5f, 0.8f, 0}};
    make_arena(r, scene);
    describe_scene(r, scene);
    const float wide = 0.45f * (float)width / (float)height;
    r->camera = (rsh_camera){.eye = {{0, 2.4f, 6.5f, 1e-3f}},
                             .forward = {{0, -0.25f, -0.97f, 0}},
                             .right = {{wide, 0, 0, 0}},
                             .up = {{0, 0.97f * 0.45f, -0.25f * 0.45f, 0}}};
}

void free_renderer(renderer* r) {
    cl_mem* const parts[] = {&r->vertices, &r->indices, &r->material_ids, &r->materials,
                             &r->lights,   &r->bounds,  &r->nodes,        &r->occlusion};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; ++i) clReleaseMemObject(*parts[i]);
    for (int bounce = 0; bounce <= BOUNCES; ++bounce) {
        const wave* w = &r->waves[bounce];
        const cl_mem of_wave[] = {w->rays,   w->hits,     w->weights, w->skip,
                                  w->colour, w->branches, w->count};
        for (size_t i = 0; i < sizeof of_wave / sizeof *of_wave; ++i)
            clReleaseMemObject(of_wave[i]);
    }
    clReleaseMemObject(r->arena);
    clReleaseKernel(r->kernel);
    clReleaseProgram(r->program);
    rsh_release_context(r->rsh);
    clReleaseCommandQueue(r->queue);
    clReleaseContext(r->context);
}
