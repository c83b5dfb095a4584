/* scene.c - triangles, materials and a lamp. */
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define RINGS 32
#define SECTORS 64
#define BALL_VERTICES ((RINGS + 1) * (SECTORS + 1))
#define BALL_TRIANGLES (2 * RINGS * SECTORS)
#define GROUND_HALF 8.0f
#define PI 3.14159265f

static void* allocate(size_t count, size_t bytes) {
    void* memory = calloc(count, bytes);
    if (memory) return memory;
    fprintf(stderr, "no memory for %lu bytes\n", (unsigned long)(count * bytes));
    exit(EXIT_FAILURE);
}

static void put_vertex(cl_float* vertex, const cl_float* centre, float size,
                       const cl_float* normal) {
    for (int c = 0; c < 3; ++c) {
        vertex[c] = centre[c] + size * normal[c];
        vertex[3 + c] = normal[c];
    }
}

static void place_ball(cl_float* vertices, float x, float y, float z, float radius) {
    const cl_float centre[3] = {x, y, z};
    for (int ring = 0; ring <= RINGS; ++ring)
        for (int sector = 0; sector <= SECTORS; ++sector) {
            const float down = PI * (float)ring / RINGS;
            const float round = 2 * PI * (float)(sector % SECTORS) / SECTORS;
            const cl_float normal[3] = {sinf(down) * cosf(round), cosf(down),
                                        sinf(down) * sinf(round)};
            put_vertex(vertices + 6 * (ring * (SECTORS + 1) + sector), centre, radius, normal);
        }
}

void place_scene(scene_arrays* scene, float time) {
    static const cl_float up[3] = {0, 1, 0};
    for (int i = 0; i < 4; ++i) {
        const cl_float corner[3] = {i % 2 ? GROUND_HALF : -GROUND_HALF, 0,
                                    i / 2 ? GROUND_HALF : -GROUND_HALF};
        put_vertex(scene->vertices + 6 * i, corner, 0, up);
    }
    cl_float* balls = scene->vertices + 6 * 4;
    place_ball(balls, -1.1f, 1.05f + 0.3f * fabsf(sinf(2 * time)), 0, 1);
    place_ball(balls + 6 * BALL_VERTICES, 1.2f * cosf(time), 0.8f, 1.6f * cosf(time), 0.75f);
}

static void add_triangle(scene_arrays* scene, cl_uint a, cl_uint b, cl_uint c,
                         cl_uint material) {
    cl_uint* corner = scene->indices + 3 * scene->triangle_count;
    corner[0] = a, corner[1] = b, corner[2] = c;
    scene->material_ids[scene->triangle_count++] = material;
}

static void add_ball(scene_arrays* scene, cl_uint first, cl_uint material) {
    for (cl_uint ring = 0; ring < RINGS; ++ring)
        for (cl_uint sector = 0; sector < SECTORS; ++sector) {
            const cl_uint a = first + ring * (SECTORS + 1) + sector, b = a + SECTORS + 1;
            add_triangle(scene, a, a + 1, b, material);
            add_triangle(scene, b, a + 1, b + 1, material);
        }
}

static rsh_material make_material(float grey, float reflection, float transmission) {
    const rsh_material material = {
        .ambient = {{grey, grey, grey, 0}},
        .diffuse = {{grey, 0.9f * grey, 0.8f * grey, 0}},
        .specular = {{0.4f, 0.4f, 0.4f, 60}},
        .reflection = {{reflection, reflection, reflection, 0}},
        .transmission = {{transmission, transmission, transmission, 1.5f}},
        .texture = RSH_NO_TEXTURE};
    return material;
}

scene_arrays make_scene(void) {
    scene_arrays scene = {.vertex_count = 4 + 2 * BALL_VERTICES};
    const cl_uint most = 2 + 2 * BALL_TRIANGLES;
    scene.vertices = allocate(scene.vertex_count, 6 * sizeof(cl_float));
    scene.indices = allocate(most, 3 * sizeof(cl_uint));
    scene.material_ids = allocate(most, sizeof(cl_uint));
    scene.materials[0] = make_material(0.8f, 0, 0);
    scene.materials[1] = make_material(0.1f, 0.8f, 0);
    scene.materials[2] = make_material(0.02f, 0, 0.95f);
    scene.lights[0] = (rsh_light){.position = {{3, 6, 4, 0}},
                                  .colour = {{30, 29, 27, 0}},
                                  .attenuation = {{1, 0, 0.5f, 0}},
                                  .kind = RSH_LIGHT_POINT,
                                  .casts_shadow = 1};
    add_triangle(&scene, 0, 2, 1, 0);
    add_triangle(&scene, 1, 2, 3, 0);
    add_ball(&scene, 4, 1);
    add_ball(&scene, 4 + BALL_VERTICES, 2);
    place_scene(&scene, 0);
    return scene;
}

void free_scene(scene_arrays* scene) {
    free(scene->vertices);
    free(scene->indices);
    free(scene->material_ids);
}
