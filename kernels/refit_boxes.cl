/* refit_boxes.cl - clusters and groups of triangles that moved, where their order stayed: the
 * same triangles in each, and the same groups, around where they are now.
 *   vertices, indices  in      triangles
 *   boxes              in/out  see scene_boxes.h
 *   loose              -       boxes around groups, by their numbers
 * Nothing is done where the order is a new one: bound_boxes.cl.
 */
#include "bound_boxes.h"

/* Clusters that follow each other mostly have numbers that do. */
#define RSH_AHEAD 3

static void clear_sides(float row[6][16], uint k)
{
    for (uint f = 0; f < 6; ++f) row[f][k] = f < 3 ? INFINITY : -INFINITY;
}

static void store_sides(float row[6][16], __global float* group, __global rsh_loose_box* around)
{
    for (uint f = 0; f < 6; ++f) {
        floatv v[RSH_VECTORS];
        for (uint i = 0; i < RSH_VECTORS; ++i) {
            v[i] = load_lanes(row[f] + RSH_WIDTH * i);
            store_whole(__global, v[i], group + 16 * f + RSH_WIDTH * i);
        }
        around->side[f] = f < 3 ? smallest_lane(v) : largest_lane(v);
    }
}

/* Returns whether intersect.h has any of the triangles to scale. */
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

/* A work-item takes the clusters of a part, and their groups. */
__kernel void rsh_refit_clusters(rsh_mesh mesh, __global const float* vertices,
                                 __global const uint* indices, rsh_scene_shape scene_shape,
                                 __global const rsh_sorting* sorting, __global float* boxes,
                                 __global rsh_loose_box* loose)
{
    const rsh_scene_shape shape = scene_shape;
    const uint me = get_global_id(0);
    if (me >= shape.parts || sorting->is_needed) return;
    const uint first = me * shape.part_groups, count = part_groups(&shape, boxes)[me];
    for (uint number = first; number < first + count; ++number) {
        __global float* group = boxes + box_group_at(&shape, number);
        __global uint* below = (__global uint*)group + RSH_BELOW_AT;
        float row[6][16];
        uint member[16];
        for (uint k = 0; k < 16; ++k) {
            member[k] = below[k] & ~RSH_SCALED;
            clear_sides(row, k);
        }
        const uint none = member[0]; /* again, behind the last */
        for (uint k = 0; k < 16 && (k == 0 || member[k] != none); ++k) {
            float side[6];
            expect_stores(boxes + cluster_at(member[k] + RSH_AHEAD));
            if (refit_cluster(mesh, vertices, indices, boxes + cluster_at(member[k]), side))
                member[k] |= RSH_SCALED;
            for (uint f = 0; f < 6; ++f) row[f][k] = side[f];
        }
        for (uint k = 0; k < 16; ++k)
            below[k] = k > 0 && member[k] == none ? member[0] : member[k];
        store_sides(row, group, loose + number);
    }
}

/* Groups of groups, members first: they have the lower numbers. */
__kernel void rsh_refit_groups(rsh_scene_shape scene_shape, __global const rsh_sorting* sorting,
                               __global float* boxes, __global rsh_loose_box* loose)
{
    if (get_global_id(0) != 0 || sorting->is_needed) return;
    const rsh_scene_shape shape = scene_shape;
    const uint last = scene_top(&shape, boxes)->group;
    for (uint number = shape.parts * shape.part_groups; number <= last; ++number) {
        __global float* group = boxes + box_group_at(&shape, number);
        __global const uint* below = (__global const uint*)group + RSH_BELOW_AT;
        float row[6][16];
        for (uint k = 0; k < 16; ++k) {
            clear_sides(row, k);
            if (k == 0 || below[k] != below[0])
                for (uint f = 0; f < 6; ++f) row[f][k] = loose[below[k]].side[f];
        }
        store_sides(row, group, loose + number);
    }
}
