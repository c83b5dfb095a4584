/* leaf_builder.h - the triangles of a part on their way into leaves: loaded 16 at a time into a
 * row, cut there (bvh/leaf_cuts.h), stored with the boxes around them. */
#ifndef RSH_BVH_LEAF_BUILDER_H
#define RSH_BVH_LEAF_BUILDER_H

#include "bvh/leaf_cuts.h"
#include "bvh/leaves.h"

typedef struct leaf_builder {
    box_row row; /* boxes around triangles, not padded */
    float corner[9][RSH_WINDOW + 16];
    uint triangle[RSH_WINDOW + 16]; /* indices, from the tree's first triangle on */
    uint first_triangle;            /* the index of that one in the scene */
    uint next, end;                 /* places in the order of what is not in the row yet */
    uint leaves, first_leaf;        /* how many are made so far; number of the first */
    uint cut;                       /* triangles in these leaves */
} leaf_builder;

/* Fills the row. leaves: of the BVH; the cache lines of those that will be stored next are
 * asked for, as leaves are stored in bursts. */
RSH_CALLED static void load_triangles(leaf_builder* part, mesh_view mesh,
                                      __global const float* vertices,
                                      __global const uint* indices, __global const uint* order,
                                      __global const float* leaves)
{
    for (; part->row.count + 16 <= RSH_WINDOW && part->next < part->end; part->next += 16) {
        const uint at = part->row.count;
        corner_rows corners;
        boxes16 boxes;
        load_corners(mesh, vertices, indices, order, part->next, &corners);
        boxes_of_corners(&corners, &boxes);
        for_each_vector(v) {
#pragma unroll
            for (uint axis = 0; axis < 3; ++axis) {
                store_whole(__private, boxes.low[axis][v],
                            part->row.side[axis] + at + RSH_WIDTH * v);
                store_whole(__private, boxes.high[axis][v],
                            part->row.side[3 + axis] + at + RSH_WIDTH * v);
            }
#pragma unroll
            for (uint i = 0; i < 9; ++i)
                store_whole(__private, corners.row[i / 3][i % 3][v],
                            part->corner[i] + at + RSH_WIDTH * v);
            store_whole_uint(__private, triangles_from(mesh, order, part->next + RSH_WIDTH * v),
                             part->triangle + at + RSH_WIDTH * v);
        }
        expect_stores(leaves + leaf_at(part->first_leaf + part->leaves + at / 15));
        part->row.count += min(16u, part->end - part->next);
    }
}

/* The room of a part (lib/bvh/layout.hpp) is for leaves of 14 triangles on the average, and
 * three more. Where the best cuts would take more leaves, the row is cut into full ones. */
RSH_CALLED static void cut_triangles(leaf_builder* part, float leaf_cost)
{
    const bool is_last = part->next >= part->end;
    cut_row(&part->row, leaf_cost, is_last);
    uint done = part->cut;
    for (uint r = 0; r < part->row.range_count; ++r) done += part->row.range_length[r];
    if (14 * (part->leaves + part->row.range_count) > done + 28)
        cut_evenly(&part->row, is_last);
}

/* Returns whether mesh/intersect.h scales any of the triangles. */
static bool store_leaf(const leaf_builder* part, uint first, uint length, __global float* leaf)
{
    corner_rows corners;
    uintv index[RSH_VECTORS];
    for_each_vector(v) {
        const intv is_there = RSH_LANES + (int)(RSH_WIDTH * v) < (intv)((int)length);
#pragma unroll
        for (uint i = 0; i < 9; ++i)
            corners.row[i / 3][i % 3][v] =
                select((floatv)(INFINITY), load_lanes(part->corner[i] + first + RSH_WIDTH * v),
                       is_there);
        index[v] =
            select((uintv)(RSH_NO_HIT),
                   load_lanes(part->triangle + first + RSH_WIDTH * v) + part->first_triangle,
                   as_uintv(is_there));
    }
    return store_triangles(&corners, index, leaf);
}

RSH_CALLED static void clear_leaves(__global float* leaf, uint count)
{
    for (; count > 0; --count, leaf += RSH_LEAF_WORDS) {
        for (uint i = 0; i < 9; ++i) vstore16((float16)(INFINITY), i, leaf);
        vstore16((uint16)(RSH_NO_HIT), 0, (__global uint*)leaf + RSH_TRIANGLES_AT);
    }
}

/* Stores the ranges of the row as leaves, and the padded boxes around them in child_boxes. */
RSH_CALLED static void store_leaves(leaf_builder* part, __global float* bvh,
                                    __global child_box* child_boxes)
{
    uint first = 0;
    for (uint r = 0; r < part->row.range_count; ++r) {
        const uint length = part->row.range_length[r];
        const uint leaf = part->first_leaf + part->leaves++;
        child_box around;
        bound_range(&part->row, first, length, around.side);
        pad_box(around.side);
        const bool is_scaled = store_leaf(part, first, length, bvh + leaf_at(leaf));
        around.child = child_of_leaf(leaf, is_scaled);
        child_boxes[leaf] = around;
        first += length;
    }
    part->cut += first;
    shift_row(&part->row, first);
    for (uint i = 0; i < 9; ++i) shift_words(part->corner[i], first, part->row.count);
    shift_words((float*)part->triangle, first, part->row.count);
}

#endif
