/* layout.h - a scene's BVH in one buffer, and where things lie in it:
 *   head     bvh_head: what the rest was made of
 *   leaves   RSH_LEAVES x bvh_leaf per tree; those that a part has room for but does not need
 *            hold no triangles
 *   nodes    RSH_NODES x bvh_node per tree: those of the parts first, then those above; then the
 *            node above both trees, where there are two
 * and per tree, the still one first:
 *   order    a word per triangle: the triangles in their order along the curve (bvh/order.cl),
 *            counted from the tree's first one
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

static ulong node_at(const bvh_whole* whole, uint node)
{
    return leaf_at(whole->leaves) + RSH_NODE_WORDS * node;
}

static __global bvh_head* head_of(__global float* bvh) { return (__global bvh_head*)bvh; }

static __global const bvh_head* const_head_of(__global const float* bvh)
{
    return (__global const bvh_head*)bvh;
}

/* Whether the trees of the buffer, made or not, lie as here. */
static bool are_laid_out_as(__global const float* bvh, bvh_whole whole)
{
    const bvh_whole held = const_head_of(bvh)->whole;
    return held.triangles == whole.triangles && held.still_triangles == whole.still_triangles &&
           held.leaves == whole.leaves && held.nodes == whole.nodes;
}

/* Whether the buffer holds that tree. Nothing else of the tree may be read before. */
static bool is_tree_made(__global const float* bvh, bvh_whole whole, uint tree)
{
    return const_head_of(bvh)->made[tree] == RSH_BVH_MADE && are_laid_out_as(bvh, whole);
}

static bool has_still(bvh_whole whole) { return whole.still_triangles > 0; }
static bool has_moving(bvh_whole whole) { return whole.still_triangles < whole.triangles; }

/* Whether the buffer holds all trees that it should. */
static bool has_trees_of(__global const float* bvh, bvh_whole whole)
{
    return (!has_still(whole) || is_tree_made(bvh, whole, RSH_STILL_TREE)) &&
           (!has_moving(whole) || is_tree_made(bvh, whole, RSH_MOVING_TREE));
}

/* Whether it holds the whole BVH. */
static bool are_made_of(__global const float* bvh, bvh_whole whole)
{
    const bool has_both = has_still(whole) && has_moving(whole);
    return has_trees_of(bvh, whole) &&
           (!has_both || const_head_of(bvh)->joined == RSH_BVH_MADE);
}

static uint top_of_tree(__global const float* bvh, uint tree)
{
    return const_head_of(bvh)->nodes[tree].end - 1;
}

/* Number of the topmost node. */
static uint top_node(__global const float* bvh, bvh_whole whole)
{
    if (!has_still(whole)) return top_of_tree(bvh, RSH_MOVING_TREE);
    if (!has_moving(whole)) return top_of_tree(bvh, RSH_STILL_TREE);
    return whole.nodes - 1;
}

/* By part. */
static __global bvh_part* bvh_parts(const bvh_layout* layout, __global float* bvh)
{
    return (__global bvh_part*)(bvh + RSH_PARTS_AT(*layout));
}

/* Of a part. */
static uint first_leaf(const bvh_layout* layout, uint part)
{
    return layout->first_leaf + part * layout->part_leaves;
}

/* Of a part; of the part behind the last: the first node above leaves of several parts. */
static uint first_node(const bvh_layout* layout, uint part)
{
    return layout->first_node + part * layout->part_nodes;
}

/* The node behind the last one of the tree. */
static uint end_node(const bvh_layout* layout)
{
    return layout->first_node + RSH_NODES(*layout);
}

#endif
