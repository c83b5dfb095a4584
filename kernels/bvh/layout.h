/* layout.h - what rsh_bound makes for the bound `box`, and how to find one's way in it:
 *   head      rsh_bounds_head: what the rest is of
 *   clusters  RSH_CLUSTERS x rsh_cluster: triangles that lie close together. Where a part needs
 *             fewer than it has room for, the others hold none
 *   groups    RSH_GROUPS x rsh_box_group: of clusters and of other groups; those of the parts
 *             first, then those above
 *   order     a word per triangle: its number, by its place (bvh/order.cl)
 *   surveys   RSH_SURVEYS x rsh_survey, of the order when it was made
 *   counts    rsh_part_counts per part
 */
#ifndef RSH_BVH_LAYOUT_H
#define RSH_BVH_LAYOUT_H

#include "bvh/types.h"

#define RSH_HEAD_WORDS 16ul
#define RSH_CLUSTER_WORDS 160ul
#define RSH_GROUP_WORDS 112ul

/* Where the words of rsh_cluster::triangle and rsh_box_group::below are. */
#define RSH_TRIANGLES_AT 144
#define RSH_BELOW_AT 96

static ulong cluster_at(uint cluster) { return RSH_HEAD_WORDS + RSH_CLUSTER_WORDS * cluster; }

/* How a group names a cluster that is in it. */
static uint below_cluster(uint cluster, bool is_scaled)
{
    return cluster | RSH_IS_CLUSTER | (is_scaled ? RSH_SCALED : 0);
}

/* Sides of a box that holds nothing: low x y z, high x y z. */
static float no_side(uint f) { return f < 3 ? INFINITY : -INFINITY; }

/* Place: 16 * cluster + where in it. */
static uint triangle_in_place(__global const float* boxes, uint place)
{
    __global const float* cluster = boxes + cluster_at(place / 16);
    return as_uint(cluster[RSH_TRIANGLES_AT + place % 16]);
}

static ulong box_group_at(const rsh_scene_shape* shape, uint group)
{
    return cluster_at(RSH_CLUSTERS(*shape)) + RSH_GROUP_WORDS * group;
}

static __global rsh_bounds_head* bounds_head(__global float* boxes)
{
    return (__global rsh_bounds_head*)boxes;
}

static __global const rsh_bounds_head* bounds_head_of(__global const float* boxes)
{
    return (__global const rsh_bounds_head*)boxes;
}

/* Nothing else of the bounds may be read before this is true. */
static bool are_made_of(__global const float* boxes, rsh_scene_shape shape)
{
    const rsh_bounds_head head = *bounds_head_of(boxes);
    return head.made == RSH_BOUNDS_MADE && head.shape.triangles == shape.triangles &&
           head.shape.part == shape.part && head.shape.parts == shape.parts &&
           head.shape.part_clusters == shape.part_clusters &&
           head.shape.part_groups == shape.part_groups &&
           head.shape.upper_groups == shape.upper_groups;
}

/* By part. */
static __global rsh_part_counts* part_counts(const rsh_scene_shape* shape,
                                             __global float* boxes)
{
    return (__global rsh_part_counts*)(boxes + RSH_COUNTS_AT(*shape));
}

/* The first group that is above clusters of several parts. */
static uint first_upper_group(const rsh_scene_shape* shape)
{
    return shape->parts * shape->part_groups;
}

#endif
