/* leaf_triangle.h - a triangle out of a leaf of the scene's BVH, that all rays of a packet are
 * tested against. */
#ifndef RSH_TRAVERSE_LEAF_TRIANGLE_H
#define RSH_TRAVERSE_LEAF_TRIANGLE_H

#include "bvh/layout.h"
#include "mesh/intersect.h"

typedef struct leaf_triangle {
    __global const float* at; /* x y z of three corners in order, 16 floats apart */
    float scale;              /* see triangle_scale */
    uint index, places;
} leaf_triangle;

static float scale_of(__global const float* at)
{
    floatv corner[9];
    for (uint i = 0; i < 9; ++i) corner[i] = (floatv)(at[16 * i]);
    const floatv scale = triangle_scale(corner);
    return ((const float*)&scale)[0];
}

/* k: which of the leaf's triangles; it must have that many. is_scaled: it may have to be. */
static leaf_triangle leaf_triangle_at(__global const float* leaf, uint k, bool is_scaled)
{
    const uint word = as_uint(leaf[RSH_TRIANGLES_AT + k]);
    leaf_triangle triangle;
    triangle.at = leaf + k;
    triangle.scale = is_scaled ? scale_of(triangle.at) : 1.0f;
    triangle.index = RSH_TRIANGLE_INDEX(word);
    triangle.places = RSH_TRIANGLE_PLACES(word);
    return triangle;
}

#endif
