/* binary_tree.h - a binary tree above boxes in their order along the curve (grow_tree.h), and
 * what each of its branches will cost in groups of 16 boxes, however many of the slots of the
 * group above are left to it:
 *   among(k) = min over i of  least(i) of the first + least(k - i) of the second
 *   alone    = among(16) + surface + price,  a group of its own, in one slot
 *   least(k) = min(among(k), alone)
 * where clusters cost nothing. A ray meets a box by its surface (the surface area heuristic);
 * the price makes for fewer groups where surfaces hardly differ.
 */
#ifndef RSH_BVH_BINARY_TREE_H
#define RSH_BVH_BINARY_TREE_H

#include "bvh/leaf_cuts.h"
#include "bvh/leaves.h"

/* What a group costs besides its surface, as a part of the scene's by the number of clusters.
 * With none, rays open up to 5 % fewer, of a fifth more groups. */
#define RSH_GROUP_PRICE 8.0f

/* A group of its own only above so many clusters: see bvh/collapse16.h. */
#define RSH_LEAST_BELOW 9

/* The tree of the scene while it grows. Boxes have numbers: those of clusters, then, after all
 * of them, those of branches. */
typedef struct rsh_tree {
    rsh_scene_shape shape;
    __global const rsh_loose_box* clusters;
    __global rsh_box_branch* branches;
    __global float* least;         /* (1) .. (16) of each branch */
    __global rsh_tree_part* parts; /* the last: of what is above them */
    __global float* tops;          /* words for rsh_tops */
} rsh_tree;

/* words: RSH_TREE_WORDS. */
static rsh_tree tree_in(rsh_scene_shape shape, __global const rsh_loose_box* clusters,
                        __global float* words)
{
    rsh_tree tree = {shape,
                     clusters,
                     (__global rsh_box_branch*)words,
                     words + RSH_LEAST_AT(shape),
                     (__global rsh_tree_part*)(words + RSH_TREE_PARTS_AT(shape)),
                     words + RSH_TOPS_AT(shape)};
    return tree;
}

static bool is_branch(const rsh_tree* tree, uint number)
{
    return number >= RSH_CLUSTERS(tree->shape);
}

static __global rsh_box_branch* branch_of(const rsh_tree* tree, uint number)
{
    return tree->branches + (number - RSH_CLUSTERS(tree->shape));
}

static __global float* least_at(const rsh_tree* tree, uint number)
{
    return tree->least + 16ul * (number - RSH_CLUSTERS(tree->shape));
}

static __global const float* sides_of(const rsh_tree* tree, uint number)
{
    return is_branch(tree, number) ? branch_of(tree, number)->side
                                   : tree->clusters[number].side;
}

static float16 least_of(const rsh_tree* tree, uint number)
{
    return is_branch(tree, number) ? vload16(0, least_at(tree, number)) : (float16)(0.0f);
}

/* among(1) .. among(16), and how many of the slots the first has in each. */
static float16 least_among(const rsh_tree* tree, uint first, uint second, uchar16* shares)
{
    const uchar16 others = (uchar16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    float behind[32], share[16];
    vstore16((float16)(INFINITY), 0, behind);
    if (!is_branch(tree, first) || !is_branch(tree, second)) { /* a slot does for the cluster */
        *shares = is_branch(tree, first) ? others : (uchar16)(1);
        vstore16(least_of(tree, is_branch(tree, first) ? first : second), 1, behind);
        return vload16(0, behind + 15);
    }
    vstore16(least_of(tree, first), 0, share);
    vstore16(least_of(tree, second), 1, behind);
    float16 least = (float16)(INFINITY);
    int16 best = (int16)(1);
#pragma unroll
    for (uint i = 1; i < 16; ++i) {
        const float16 sum = share[i - 1] + vload16(0, behind + 16 - i);
        const int16 is_less = sum < least;
        least = select(least, sum, is_less);
        best = select(best, (int16)((int)i), is_less);
    }
    *shares = convert_uchar16(best);
    return least;
}

static uint clusters_below(const rsh_tree* tree, uint number)
{
    return is_branch(tree, number) ? branch_of(tree, number)->clusters : 1;
}

static void set_branch(const rsh_tree* tree, float price, uint number, uint first, uint second,
                       const float* side)
{
    __global rsh_box_branch* branch = branch_of(tree, number);
    const uint clusters = clusters_below(tree, first) + clusters_below(tree, second);
    uchar16 shares;
    const float16 among = least_among(tree, first, second, &shares);
    const float surface = fmin(surface_of(side, side + 3), RSH_MOST_SURFACE);
    const float16 alone =
        (float16)(clusters < RSH_LEAST_BELOW ? INFINITY : among.sf + (surface + price));
    const int16 is_group = alone < among;
    vstore16(select(among, alone, is_group), 0, least_at(tree, number));
    vstore16(select(shares, (uchar16)(0), convert_uchar16(is_group)), 0,
             (__global uchar*)branch->shares);
    for (uint f = 0; f < 6; ++f) branch->side[f] = side[f];
    branch->below[0] = first;
    branch->below[1] = second;
    branch->clusters = clusters;
}

#endif
