/* leaves.h - triangles, 16 at a time: the boxes around them, and where leaves keep them. */
#ifndef RSH_BVH_LEAVES_H
#define RSH_BVH_LEAVES_H

#include "bvh/corners.h"
#include "bvh/layout.h"
#include "mesh/boxes16.h"
#include "mesh/intersect.h"

/* Boxes of 16 triangles, not padded; empty for those that are never hit. */
RSH_CALLED static void boxes_of_corners(const corner_rows* corners, boxes16* boxes)
{
#pragma unroll
    for (uint axis = 0; axis < 3; ++axis)
        for_each_vector(v) {
            const floatv a = corners->row[0][axis][v], b = corners->row[1][axis][v],
                         c = corners->row[2][axis][v];
            const floatv high = greater(a, greater(b, c));
            boxes->low[axis][v] = lesser(a, lesser(b, c));
            boxes->high[axis][v] = select((floatv)(-INFINITY), high, high < (floatv)(INFINITY));
        }
}

/* Stores triangles with their indices. Returns whether mesh/intersect.h scales any of them. */
static bool store_triangles(const corner_rows* corners, const uintv* index,
                            __global float* leaf)
{
    uint scaled = 0;
    for_each_vector(v) {
        floatv corner[9];
#pragma unroll
        for (uint i = 0; i < 9; ++i) corner[i] = corners->row[i / 3][i % 3][v];
        const uintv places = put_lanes_in_order(corner);
#pragma unroll
        for (uint i = 0; i < 9; ++i)
            store_whole(__global, corner[i], leaf + 16 * i + RSH_WIDTH * v);
        store_whole_uint(__global, index[v] | places << RSH_PLACES_SHIFT,
                         leaf + RSH_TRIANGLES_AT + RSH_WIDTH * v);
        scaled |= RSH_LANE_BITS((triangle_scale(corner) != (floatv)(1.0f)) &
                                (corner[0] < (floatv)(INFINITY)));
    }
    return scaled != 0;
}

/* Asks for the cache lines of a leaf that will be written soon. */
static void expect_stores(__global const float* leaf)
{
#pragma unroll
    for (uint i = 0; i < 10; ++i) RSH_EXPECT_STORE(leaf + 16 * i);
}

/* Pads a box as rays/box_node.h derives. side: low x y z, high x y z. */
static void pad_box(float* side)
{
    if (!(side[0] <= side[3])) return; /* empty */
    float reach = 0.0f;
#pragma unroll
    for (uint f = 0; f < 6; ++f) {
        const float away = fabs(side[f]);
        reach = away > reach ? away : reach;
    }
    const float pad = pad_of(reach);
#pragma unroll
    for (uint f = 0; f < 6; ++f) side[f] += f < 3 ? -pad : pad;
}

/* Half the surface of a box; 0 if it is empty. */
static float surface_of(const float* low, const float* high)
{
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x >= 0.0f ? x * y + y * z + z * x : 0.0f;
}

#endif
