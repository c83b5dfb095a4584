/* refit.cl - clusters and groups of triangles that moved, where their order stayed: the
 * same triangles in each, and the same groups, around where they are now.
 *   vertices, indices  in      triangles
 *   boxes              in/out  see bvh/layout.h
 *   loose              -       boxes around clusters, by their numbers, then around groups
 * Nothing is done where the order is a new one: bvh/leaves.cl. Numbers that the boxes hold are
 * brought within the scene's shape: a buffer that something else wrote to leads nowhere outside.
 */
#include "bvh/leaves.h"
#include "order/types.h"

/* Clusters on from the one that is fitted. */
#define RSH_AHEAD 3

/* Returns whether mesh/intersect.h has any of the triangles to scale. */
static bool refit_cluster(rsh_mesh mesh, __global const float* vertices,
                          __global const uint* indices, __global float* cluster, float* side)
{
    rsh_corner_rows corners;
    rsh_boxes boxes;
    load_numbered_corners(mesh, vertices, indices,
                          (__global const uint*)cluster + RSH_TRIANGLES_AT, &corners);
    store_corners(&corners, cluster);
    boxes_of_corners(&corners, &boxes);
#pragma unroll
    for (uint axis = 0; axis < 3; ++axis) {
        side[axis] = smallest_lane(boxes.low[axis]);
        side[3 + axis] = largest_lane(boxes.high[axis]);
    }
    pad_box(side);
    return is_any_scaled(&corners);
}

/* The box around each box of a group, and around all. around: of the groups, by their numbers,
 * those that are in it fitted already. */
static void refit_group(const rsh_scene_shape* shape, uint number, __global float* boxes,
                        __global const rsh_loose_box* clusters, __global rsh_loose_box* around)
{
    __global float* group = boxes + box_group_at(shape, number);
    __global uint* below = (__global uint*)group + RSH_BELOW_AT;
    float row[6][16];
    for (uint k = 0; k < 16; ++k) {
        const uint member = below[k];
        const bool is_there = member != RSH_NO_BOX, is_cluster = member & RSH_IS_CLUSTER;
        const uint last = (is_cluster ? RSH_CLUSTERS(*shape) : RSH_GROUPS(*shape)) - 1;
        __global const rsh_loose_box* of = (is_cluster ? clusters : around) +
                                           (is_there ? min(RSH_BELOW_NUMBER(member), last) : 0);
        for (uint f = 0; f < 6; ++f) row[f][k] = is_there ? of->side[f] : no_side(f);
        if (is_there && is_cluster) below[k] = of->below;
    }
    for (uint f = 0; f < 6; ++f) {
        floatv v[RSH_VECTORS];
        for (uint i = 0; i < RSH_VECTORS; ++i) {
            v[i] = load_lanes(row[f] + RSH_WIDTH * i);
            store_whole(__global, v[i], group + 16 * f + RSH_WIDTH * i);
        }
        around[number].side[f] = f < 3 ? smallest_lane(v) : largest_lane(v);
    }
}

static rsh_group_range within(rsh_group_range range, uint first, uint end)
{
    return (rsh_group_range){max(range.first, first), min(range.end, end)};
}

/* A work-item takes the clusters of a part, and its groups. */
__kernel void rsh_refit_clusters(rsh_mesh mesh, __global const float* vertices,
                                 __global const uint* indices, rsh_scene_shape scene_shape,
                                 __global const rsh_sorting* sorting, __global float* boxes,
                                 __global rsh_loose_box* loose)
{
    const rsh_scene_shape shape = scene_shape;
    const uint me = get_global_id(0);
    if (me >= shape.parts || sorting->is_needed) return;
    const rsh_part_counts counts = part_counts(&shape, boxes)[me];
    const uint first = me * shape.part_clusters, first_group = me * shape.part_groups;
    const uint end = first + min(counts.clusters, shape.part_clusters);
    for (uint c = first; c < end; ++c) {
        rsh_loose_box around;
        expect_stores(boxes + cluster_at(c + RSH_AHEAD));
        const bool is_scaled =
            refit_cluster(mesh, vertices, indices, boxes + cluster_at(c), around.side);
        around.below = below_cluster(c, is_scaled);
        loose[c] = around;
    }
    const rsh_group_range groups =
        within(counts.groups, first_group, first_group + shape.part_groups);
    for (uint g = groups.first; g < groups.end; ++g)
        refit_group(&shape, g, boxes, loose, loose + RSH_CLUSTERS(shape));
}

/* The groups above several parts. */
__kernel void rsh_refit_groups(rsh_scene_shape scene_shape, __global const rsh_sorting* sorting,
                               __global float* boxes, __global rsh_loose_box* loose)
{
    if (get_global_id(0) != 0 || sorting->is_needed) return;
    const rsh_scene_shape shape = scene_shape;
    const rsh_group_range groups =
        within(bounds_head(boxes)->groups, first_upper_group(&shape), RSH_GROUPS(shape));
    for (uint g = groups.first; g < groups.end; ++g)
        refit_group(&shape, g, boxes, loose, loose + RSH_CLUSTERS(shape));
}
