/* layout.h - a scene's BVH in one buffer, and where things lie in it:
 *   head     bvh_head: what the rest was made of
 *   leaves   RSH_LEAVES x bvh_leaf; those that a part has room for but does not need hold no
 *            triangles
 *   nodes    RSH_NODES x bvh_node; those of the parts first, then those above
 *   order    a word per triangle: the triangles in their order along the curve (bvh/order.cl)
 *   quality  RSH_QUALITY_SAMPLES x refit_quality, of the order when it was made
 *   parts    bvh_part per part
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

/* bvh_node::child of a leaf. */
static uint child_of_leaf(uint leaf, bool is_scaled)
{
    return leaf | RSH_IS_LEAF | (is_scaled ? RSH_SCALED : 0);
}

/* Side f of an empty box: low x y z, high x y z. */
static float empty_side(uint f) { return f < 3 ? INFINITY : -INFINITY; }

static ulong node_at(const bvh_layout* layout, uint node)
{
    return leaf_at(RSH_LEAVES(*layout)) + RSH_NODE_WORDS * node;
}

static __global bvh_head* head_of(__global float* bvh) { return (__global bvh_head*)bvh; }

static __global const bvh_head* const_head_of(__global const float* bvh)
{
    return (__global const bvh_head*)bvh;
}

/* Whether the buffer holds a BVH of this layout. Nothing else of it may be read before. */
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

/* The first node above leaves of several parts. */
static uint first_upper_node(const bvh_layout* layout)
{
    return layout->parts * layout->part_nodes;
}

#endif
