/* bound_boxes.cl - clusters of 16 triangles, boxes around them, around runs of 16 of these, and
 * so on.
 *   vertices, indices  in      triangles
 *   boxes              in/out  see scene_boxes.h; in: their order
 * Does not look at rays.
 */
#include "bound_boxes.h"
#include "intersect.h"

/* Returns whether intersect.h has any of the triangles to scale. */
static bool bound_cluster(const rsh_corner_rows* corners, float* around)
{
    rsh_boxes boxes;
    boxes_of_corners(corners, &boxes);
    float reach = 0.0f;
#pragma unroll
    for (uint axis = 0; axis < 3; ++axis) {
        around[axis] = smallest_lane(boxes.low[axis]);
        around[3 + axis] = largest_lane(boxes.high[axis]);
        reach = fmax(reach, fmax(fabs(around[axis]), fabs(around[3 + axis])));
    }
    const float pad = around[0] <= around[3] ? pad_of(reach) : 0.0f;
#pragma unroll
    for (uint axis = 0; axis < 3; ++axis) {
        around[axis] -= pad;
        around[3 + axis] += pad;
    }
    uint scaled = 0;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        floatv corner[9];
#pragma unroll
        for (uint i = 0; i < 9; ++i) corner[i] = corners->row[i / 3][i % 3][v];
        scaled |= RSH_LANE_BITS((triangle_scale(corner) != (floatv)(1.0f)) &
                                (corner[0] < (floatv)(INFINITY)));
    }
    return scaled != 0;
}

static void store_corners(const rsh_corner_rows* corners, __global float* cluster)
{
#pragma unroll
    for (uint i = 0; i < 9; ++i)
        for (uint v = 0; v < RSH_VECTORS; ++v)
            store_lanes(corners->row[i / 3][i % 3][v], cluster + 16 * i + RSH_WIDTH * v);
}

/* A work-item makes 16 clusters and the group of their boxes. */
__kernel void rsh_bound_clusters(rsh_mesh mesh, __global const float* vertices,
                                 __global const uint* indices, rsh_box_levels shape,
                                 __global float* boxes)
{
    const rsh_box_levels levels = shape;
    const uint me = get_global_id(0), clusters = levels.boxes[1];
    if (me >= (clusters + 15) / 16) return; /* launch is rounded up to whole groups */
    __global uint* words = (__global uint*)boxes;
    float row[6][16];
    uint scaled = 0;
    for (uint k = 0; k < 16; ++k) {
        const uint cluster = 16 * me + k;
        float around[6];
        clear_box(around);
        if (cluster < clusters) {
            rsh_corner_rows corners;
            load_corners(mesh, vertices, indices, words + order_at(&levels), 16 * cluster,
                         &corners);
            if (bound_cluster(&corners, around)) scaled |= 1u << k;
            store_corners(&corners, boxes + cluster_at(cluster));
        }
        for (uint f = 0; f < 6; ++f) row[f][k] = around[f];
    }
    store_group(row, boxes + box_group_at(&levels, 1, me));
    words[scaled_at(&levels) + me] = scaled;
}

/* Boxes of a level from the groups of the level below; a work-item makes a group of them. */
__kernel void rsh_bound_groups(rsh_box_levels shape, uint level, __global float* boxes)
{
    const rsh_box_levels levels = shape;
    const uint me = get_global_id(0), count = levels.boxes[level];
    if (me >= (count + 15) / 16) return; /* launch is rounded up to whole groups */
    float row[6][16];
    for (uint k = 0; k < 16; ++k) {
        float around[6];
        clear_box(around);
        if (16 * me + k < count) {
            __global const float* below = boxes + box_group_at(&levels, level - 1, 16 * me + k);
#pragma unroll
            for (uint axis = 0; axis < 3; ++axis) {
                around[axis] = smallest_in_row(below + 16 * axis);
                around[3 + axis] = largest_in_row(below + 48 + 16 * axis);
            }
        }
        for (uint f = 0; f < 6; ++f) row[f][k] = around[f];
    }
    store_group(row, boxes + box_group_at(&levels, level, me));
}
