/* binary_tree.h - a binary tree over boxes that lie in order along the curve (bvh/ploc.h builds
 * it), and what each of its branches costs when it is collapsed into nodes of 16
 * (bvh/collapse16.h).
 *
 * A ray visits a box in proportion to its surface (the surface area heuristic), so a node costs
 * its surface, and RSH_TREE_NODE_COST, which makes for fewer nodes where surfaces hardly
 * differ; leaves cost nothing. A branch that is given k slots of the node above it either lets
 * its two children share them, or becomes a node of its own, in one slot, whose 16 slots its
 * children share:
 *   among(k) = min over i of  least(i) of the first child + least(k - i) of the second
 *   alone    = among(16) + surface + node cost
 *   least(k) = min(among(k), alone)
 */
#ifndef RSH_BVH_BINARY_TREE_H
#define RSH_BVH_BINARY_TREE_H

#include "bvh/leaf_cuts.h"
#include "bvh/leaves.h"

/* A branch over fewer leaves never becomes a node of its own; bvh/collapse16.h counts on it. */
#define RSH_LEAST_LEAVES 9

/* The tree while it grows. Leaves and branches are numbered together, the leaves first, from the
 * first leaf of this tree on. */
typedef struct binary_tree {
    bvh_layout layout;
    __global const child_box* leaves; /* of this tree */
    __global tree_branch* branches;
    __global float* least_cost; /* least(1) .. least(16) of each branch */
    __global tree_part* parts;  /* the last one: of what is above all parts */
    __global float* active;     /* words for active_nodes */
} binary_tree;

/* words: RSH_TREE_WORDS. */
static binary_tree tree_in(bvh_layout layout, __global const child_box* leaves,
                           __global float* words)
{
    binary_tree tree = {layout,
                        leaves,
                        (__global tree_branch*)words,
                        words + RSH_LEAST_COST_AT(layout),
                        (__global tree_part*)(words + RSH_TREE_PARTS_AT(layout)),
                        words + RSH_ACTIVE_AT(layout)};
    return tree;
}

static bool is_branch(const binary_tree* tree, uint number)
{
    return number >= RSH_LEAVES(tree->layout);
}

static __global tree_branch* branch_of(const binary_tree* tree, uint number)
{
    return tree->branches + (number - RSH_LEAVES(tree->layout));
}

static __global float* least_cost_at(const binary_tree* tree, uint number)
{
    return tree->least_cost + 16ul * (number - RSH_LEAVES(tree->layout));
}

static __global const float* sides_of(const binary_tree* tree, uint number)
{
    return is_branch(tree, number) ? branch_of(tree, number)->side : tree->leaves[number].side;
}

static float16 least_cost_of(const binary_tree* tree, uint number)
{
    return is_branch(tree, number) ? vload16(0, least_cost_at(tree, number)) : (float16)(0.0f);
}

/* among(1) .. among(16); slot_split: how many of the slots the first child has in each. */
static float16 cost_among(const binary_tree* tree, uint first, uint second, uchar16* slot_split)
{
    const uchar16 others = (uchar16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    float behind[32], ahead[16];
    vstore16((float16)(INFINITY), 0, behind);
    if (!is_branch(tree, first) || !is_branch(tree, second)) { /* a leaf needs one slot */
        *slot_split = is_branch(tree, first) ? others : (uchar16)(1);
        vstore16(least_cost_of(tree, is_branch(tree, first) ? first : second), 1, behind);
        return vload16(0, behind + 15);
    }
    vstore16(least_cost_of(tree, first), 0, ahead);
    vstore16(least_cost_of(tree, second), 1, behind);
    float16 least = (float16)(INFINITY);
    int16 best = (int16)(1);
#pragma unroll
    for (uint i = 1; i < 16; ++i) {
        const float16 sum = ahead[i - 1] + vload16(0, behind + 16 - i);
        const int16 is_less = sum < least;
        least = select(least, sum, is_less);
        best = select(best, (int16)((int)i), is_less);
    }
    *slot_split = convert_uchar16(best);
    return least;
}

static uint leaves_below(const binary_tree* tree, uint number)
{
    return is_branch(tree, number) ? branch_of(tree, number)->leaves : 1;
}

static void set_branch(const binary_tree* tree, float node_cost, uint number, uint first,
                       uint second, const float* side)
{
    __global tree_branch* branch = branch_of(tree, number);
    const uint leaves = leaves_below(tree, first) + leaves_below(tree, second);
    uchar16 slot_split;
    const float16 among = cost_among(tree, first, second, &slot_split);
    const float surface = fmin(surface_of(side, side + 3), RSH_MOST_SURFACE);
    const float16 alone =
        (float16)(leaves < RSH_LEAST_LEAVES ? INFINITY : among.sf + (surface + node_cost));
    const int16 is_node = alone < among;
    vstore16(select(among, alone, is_node), 0, least_cost_at(tree, number));
    vstore16(select(slot_split, (uchar16)(0), convert_uchar16(is_node)), 0,
             (__global uchar*)branch->slot_split);
    for (uint f = 0; f < 6; ++f) branch->side[f] = side[f];
    branch->child[0] = first;
    branch->child[1] = second;
    branch->leaves = leaves;
}

#endif
