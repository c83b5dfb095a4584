/* bound_boxes.cl - boxes around the triangles, around runs of 16 of them (clusters), around
 * runs of 16 clusters, and so on.
 *   vertices, indices  in   triangles
 *   unordered          out  boxes of the clusters, in groups; order_boxes.cl takes them on
 *   boxes              out  levels 0, and 2 and up; see scene_boxes.h
 * One pass over the triangles: no tree is searched for. Does not look at rays.
 */
#include "bound_boxes.h"

/* A work-item bounds 16 clusters: one group. */
__kernel void rsh_bound_triangles(rsh_mesh mesh, __global const float* vertices,
                                  __global const uint* indices, rsh_box_levels levels,
                                  __global float* boxes, __global float* unordered)
{
    const uint me = get_global_id(0), clusters = levels.boxes[1];
    if (me >= (clusters + 15) / 16) return; /* launch is rounded up to whole groups */
    float row[6][16];
    for (uint k = 0; k < 16; ++k) {
        float around[6];
        clear_box(around);
        if (16 * me + k < clusters)
            bound_cluster(mesh, vertices, indices, 0, 16 * me + k, boxes, around);
        for (uint f = 0; f < 6; ++f) row[f][k] = around[f];
    }
    store_group(row, unordered + RSH_GROUP_WORDS * me);
}

/* Boxes of a level from the groups of the level below; a work-item makes a group of them. */
__kernel void rsh_bound_groups(rsh_box_levels shape, uint level, __global float* boxes)
{
    const rsh_box_levels levels = shape;
    const uint me = get_global_id(0), count = levels.boxes[level];
    if (me >= (count + 15) / 16) return; /* launch is rounded up to whole groups */
    __global const float* below =
        boxes + RSH_GROUP_WORDS * (levels.first_group[level - 1] + 16 * me);
    float row[6][16];
    for (uint k = 0; k < 16; ++k) {
        float around[6];
        clear_box(around);
        if (16 * me + k < count)
            for (uint axis = 0; axis < 3; ++axis) {
                __global const float* in = below + RSH_GROUP_WORDS * k + 16 * axis;
                around[axis] = smallest_in_row(in);
                around[3 + axis] = largest_in_row(in + 48);
            }
        for (uint f = 0; f < 6; ++f) row[f][k] = around[f];
    }
    store_group(row, boxes + RSH_GROUP_WORDS * (levels.first_group[level] + me));
}
