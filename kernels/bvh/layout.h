/* layout.h - what rsh_bound makes for the bound `box`, and how to find one's way in it:
 *   head      bvh_head: what the rest is of
 *   leaves  RSH_LEAVES x bvh_leaf: triangles that lie close together. Where a part needs
 *             fewer than it has room for, the others hold none
 *   nodes    RSH_NODES x bvh_node: of leaves and of other nodes; those of the parts
 *             first, then those above
 *   order     a word per triangle: its number, by its place (bvh/order.cl)
 *   qualities   RSH_QUALITY_SAMPLES x refit_quality, of the order when it was made
 *   counts    bvh_part per part
 */
#ifndef RSH_BVH_LAYOUT_H
#define RSH_BVH_LAYOUT_H

#include "bvh/types.h"

#define RSH_HEAD_WORDS 16ul
#define RSH_LEAF_WORDS 160ul
#define RSH_NODE_WORDS 112ul

/* Where the words of bvh_leaf::triangle and bvh_node::child are. */
#define RSH_TRIANGLES_AT 144
#define RSH_CHILDREN_AT 96

static ulong leaf_at(uint leaf) { return RSH_HEAD_WORDS + RSH_LEAF_WORDS * leaf; }

/* How a node names a leaf that is in it. */
static uint child_of_leaf(uint leaf, bool is_scaled)
{
    return leaf | RSH_IS_LEAF | (is_scaled ? RSH_SCALED : 0);
}

/* Sides of a box that holds nothing: low x y z, high x y z. */
static float empty_side(uint f) { return f < 3 ? INFINITY : -INFINITY; }

/* Place: 16 * leaf + where in it. */
static uint triangle_at_place(__global const float* bvh, uint place)
{
    __global const float* leaf = bvh + leaf_at(place / 16);
    return as_uint(leaf[RSH_TRIANGLES_AT + place % 16]);
}

static ulong node_at(const bvh_layout* layout, uint node)
{
    return leaf_at(RSH_LEAVES(*layout)) + RSH_NODE_WORDS * node;
}

static __global bvh_head* head_of(__global float* bvh) { return (__global bvh_head*)bvh; }

static __global const bvh_head* const_head_of(__global const float* bvh)
{
    return (__global const bvh_head*)bvh;
}

/* Nothing else of the bounds may be read before this is true. */
static bool are_made_of(__global const float* bvh, bvh_layout layout)
{
    const bvh_head head = *const_head_of(bvh);
    return head.made == RSH_BVH_MADE && head.layout.triangles == layout.triangles &&
           head.layout.part == layout.part && head.layout.parts == layout.parts &&
           head.layout.part_leaves == layout.part_leaves &&
           head.layout.part_nodes == layout.part_nodes &&
           head.layout.upper_nodes == layout.upper_nodes;
}

/* By part. */
static __global bvh_part* bvh_parts(const bvh_layout* layout, __global float* bvh)
{
    return (__global bvh_part*)(bvh + RSH_PARTS_AT(*layout));
}

/* The first node that is above leaves of several parts. */
static uint first_upper_node(const bvh_layout* layout)
{
    return layout->parts * layout->part_nodes;
}

#endif
