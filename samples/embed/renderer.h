/* renderer.h - a renderer around rsh: OpenCL context, memory and shading are its own. */
#ifndef EMBED_RENDERER_H
#define EMBED_RENDERER_H

#include "scene.h"

#define BOUNCES 4

/* The rays of a bounce: a screen, then packed lists whose lengths only the device knows. */
typedef struct wave {
    cl_uint width, height; /* of a list, how many it may hold */
    cl_mem rays, hits, weights, skip, colour, branches, count;
} wave;

typedef struct renderer {
    cl_context context;
    cl_device_id device;
    cl_command_queue queue; /* out of order: events alone tell what comes after what */
    rsh_context rsh;
    cl_program program;
    cl_kernel kernel;
    cl_mem arena; /* every other buffer is a part of it */
    size_t alignment, used;
    cl_mem vertices, indices, material_ids, materials, lights;
    cl_mem bounds, nodes, occlusion;
    wave waves[BOUNCES + 1];
    cl_uint counts[BOUNCES + 1][2]; /* as rsh_spawn_wave leaves them */
    rsh_scene scene;
    rsh_camera camera;
    cl_event waits[2]; /* what the next command waits for */
    cl_uint wait_count;
} renderer;

/* Exits with a message unless the call succeeded. */
void require(cl_int status, const char* call);

void make_renderer(renderer* r, const scene_arrays* scene, cl_uint width, cl_uint height);
void free_renderer(renderer* r);

/* Enqueues. What the picture waits for is in r->waits. */
void move_vertices(renderer* r, const scene_arrays* scene);
void render(renderer* r);

/* Waits for all that was enqueued. Exits when a wave had more rays than room. */
void finish(renderer* r);

#endif
