/* bound_boxes.cl - boxes around the triangles, around runs of 16 of them (clusters), around
 * runs of 16 clusters, and so on: 16 boxes side by side make a group, see rsh_box_group.
 *   vertices, indices  in   triangles
 *   groups             out  level 0: triangles; level l + 1: the groups of level l
 * One pass over the triangles in their own order: no tree is searched for. Does not look at
 * rays.
 */
#include "box.h"

/* What is never hit: holds nothing, and adds nothing to the box around it. */
static void clear_box(float* box)
{
    for (int axis = 0; axis < 3; ++axis) {
        box[axis] = INFINITY;
        box[3 + axis] = -INFINITY;
    }
}

/* Rows of a group: corner[3 * i + axis][lane]. */
static void load_corners(rsh_mesh mesh, __global const float* vertices,
                         __global const uint* indices, uint first, float corner[9][16])
{
    for (uint lane = 0; lane < 16; ++lane) {
        rsh_triangle p;
        if (first + lane >= mesh.triangle_count ||
            !load_triangle(mesh, vertices, indices, first + lane, &p))
            p.v0 = p.v1 = p.v2 = (float3)(NAN);
        corner[0][lane] = p.v0.x;
        corner[1][lane] = p.v0.y;
        corner[2][lane] = p.v0.z;
        corner[3][lane] = p.v1.x;
        corner[4][lane] = p.v1.y;
        corner[5][lane] = p.v1.z;
        corner[6][lane] = p.v2.x;
        corner[7][lane] = p.v2.y;
        corner[8][lane] = p.v2.z;
    }
}

static float lowest(floatv* v)
{
    float lane[16];
    for (uint i = 0; i < RSH_VECTORS; ++i) store_lanes(v[i], lane + RSH_WIDTH * i);
    float low = INFINITY;
    for (uint i = 0; i < 16; ++i) low = fmin(low, lane[i]);
    return low;
}

static float highest(floatv* v)
{
    float lane[16];
    for (uint i = 0; i < RSH_VECTORS; ++i) store_lanes(v[i], lane + RSH_WIDTH * i);
    float high = -INFINITY;
    for (uint i = 0; i < 16; ++i) high = fmax(high, lane[i]);
    return high;
}

/* Boxes of 16 triangles, padded as box.h says, and the box around them. */
static void bound_triangles(float corner[9][16], __global float* group, float* around)
{
    floatv low[3][RSH_VECTORS], high[3][RSH_VECTORS];
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const uint at = RSH_WIDTH * v;
        floatv largest = (floatv)(0.0f), sum = (floatv)(0.0f);
        for (uint axis = 0; axis < 3; ++axis) {
            const floatv a = load_lanes(corner[axis] + at), b = load_lanes(corner[3 + axis] + at),
                         c = load_lanes(corner[6 + axis] + at);
            low[axis][v] = lesser(a, lesser(b, c));
            high[axis][v] = greater(a, greater(b, c));
            largest = greater(fabs(low[axis][v]), greater(fabs(high[axis][v]), largest));
            sum += (a - a) + (b - b) + (c - c); /* 0, or NaN if any is not finite */
        }
        const floatv pad = (floatv)(0x1p-18f) * largest + (floatv)(0x1p-124f);
        const intv is_finite = sum == (floatv)(0.0f);
        for (uint axis = 0; axis < 3; ++axis) {
            low[axis][v] = select((floatv)(INFINITY), low[axis][v] - pad, is_finite);
            high[axis][v] = select((floatv)(-INFINITY), high[axis][v] + pad, is_finite);
            store_lanes(low[axis][v], group + 16 * axis + at);
            store_lanes(high[axis][v], group + 48 + 16 * axis + at);
        }
    }
    for (uint axis = 0; axis < 3; ++axis) {
        around[axis] = lowest(low[axis]);
        around[3 + axis] = highest(high[axis]);
    }
}

/* A work-item bounds 16 clusters: one group of level 1. */
__kernel void rsh_bound_triangles(rsh_mesh mesh, __global const float* vertices,
                                  __global const uint* indices, rsh_box_levels levels,
                                  __global float* groups)
{
    const uint me = get_global_id(0);
    const uint clusters = levels.boxes[1];
    if (me >= (clusters + 15) / 16) return; /* launch is rounded up to whole groups */
    float row[6][16];
    for (uint k = 0; k < 16; ++k) {
        const uint cluster = 16 * me + k;
        float around[6];
        clear_box(around);
        if (cluster < clusters) {
            float corner[9][16];
            load_corners(mesh, vertices, indices, 16 * cluster, corner);
            bound_triangles(corner, groups + 96ul * cluster, around);
        }
        for (uint f = 0; f < 6; ++f) row[f][k] = around[f];
    }
    __global float* out = groups + 96ul * (levels.first_group[1] + me);
    for (uint f = 0; f < 6; ++f)
        for (uint k = 0; k < 16; ++k) out[16 * f + k] = row[f][k];
}

/* Boxes of a level from the groups of the level below; a work-item makes a group of them. */
__kernel void rsh_bound_groups(rsh_box_levels shape, uint level, __global float* groups)
{
    const rsh_box_levels levels = shape;
    const uint me = get_global_id(0), count = levels.boxes[level];
    if (me >= (count + 15) / 16) return;
    __global float* out = groups + 96ul * (levels.first_group[level] + me);
    for (uint k = 0; k < 16; ++k) {
        float around[6];
        clear_box(around);
        if (16 * me + k < count) {
            __global const float* in = groups + 96ul * (levels.first_group[level - 1] + 16 * me + k);
            for (uint axis = 0; axis < 3; ++axis)
                for (uint lane = 0; lane < 16; ++lane) {
                    around[axis] = fmin(around[axis], in[16 * axis + lane]);
                    around[3 + axis] = fmax(around[3 + axis], in[48 + 16 * axis + lane]);
                }
        }
        for (uint f = 0; f < 6; ++f) out[16 * f + k] = around[f];
    }
}
