/* scene.h - the scene of this sample: a mirror ball and a glass ball over a ground, made of numbers. */
#ifndef EMBED_SCENE_H
#define EMBED_SCENE_H

#include <rsh/rsh.h>

#define MATERIALS 3
#define LIGHTS 1

/* Vertices are interleaved: six floats each, the position, then the normal. */
typedef struct scene_arrays {
    cl_float* vertices;
    cl_uint* indices;      /* three per triangle */
    cl_uint* material_ids; /* one per triangle   */
    cl_uint vertex_count, triangle_count;
    rsh_material materials[MATERIALS];
    rsh_light lights[LIGHTS];
} scene_arrays;

/* Makes everything, and frees it. Exits when there is no memory. */
scene_arrays make_scene(void);
void free_scene(scene_arrays* scene);

/* Moves the vertices to where they are at a time, in seconds. */
void place_scene(scene_arrays* scene, float time);

#endif
