/* layout.h - what rsh_bound makes for the bound `box`, and how to find one's way in it:
 *   clusters  RSH_CLUSTERS x rsh_cluster: triangles that lie close together. Where a part needs
 *             fewer than it has room for, the others hold none
 *   groups    RSH_GROUPS x rsh_box_group: of clusters and of other groups; those of the parts
 *             first, then those above
 *   order     a word per triangle: its number, by its place (bvh/order.cl)
 *   surveys   RSH_SURVEYS x rsh_survey, of the order when it was made
 *   top       rsh_scene_top
 *   counts    rsh_part_counts per part
 */
#ifndef RSH_BVH_LAYOUT_H
#define RSH_BVH_LAYOUT_H

#include "bvh/types.h"

#define RSH_CLUSTER_WORDS 160ul
#define RSH_GROUP_WORDS 112ul

/* Where the words of rsh_cluster::triangle and rsh_box_group::below are. */
#define RSH_TRIANGLES_AT 144
#define RSH_BELOW_AT 96

static ulong cluster_at(uint cluster) { return RSH_CLUSTER_WORDS * cluster; }

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
    return RSH_CLUSTER_WORDS * RSH_CLUSTERS(*shape) + RSH_GROUP_WORDS * group;
}

static __global rsh_scene_top* scene_top(const rsh_scene_shape* shape, __global float* boxes)
{
    return (__global rsh_scene_top*)(boxes + RSH_TOP_AT(*shape));
}

static __global const rsh_scene_top* scene_top_of(const rsh_scene_shape* shape,
                                                  __global const float* boxes)
{
    return (__global const rsh_scene_top*)(boxes + RSH_TOP_AT(*shape));
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
