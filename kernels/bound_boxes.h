/* bound_boxes.h - boxes around 16 triangles, and the box around these. */
#ifndef RSH_BOUND_BOXES_H
#define RSH_BOUND_BOXES_H

#include "box.h"
#include "scene_boxes.h"

/* What is never hit: holds nothing, and adds nothing to the box around it. */
static void clear_box(float* box)
{
    for (int axis = 0; axis < 3; ++axis) {
        box[axis] = INFINITY;
        box[3 + axis] = -INFINITY;
    }
}

/* Corners of 16 triangles, component by component. */
typedef struct rsh_corner_rows {
    floatv row[3][3][RSH_VECTORS]; /* [corner][axis] */
} rsh_corner_rows;

/* x y z of sixteen vertices, from four floats each. */
static void transpose_vertices(const float* vertex, floatv row[3][RSH_VECTORS])
{
#if RSH_WIDTH == 16
    float16 four[4], two[2][2];
    for (uint i = 0; i < 4; ++i) four[i] = vload16(i, vertex);
    for (uint i = 0; i < 2; ++i) {
        two[0][i] = RSH_EVEN(four[2 * i], four[2 * i + 1]);
        two[1][i] = RSH_ODD(four[2 * i], four[2 * i + 1]);
    }
    row[0][0] = RSH_EVEN(two[0][0], two[0][1]);
    row[1][0] = RSH_EVEN(two[1][0], two[1][1]);
    row[2][0] = RSH_ODD(two[0][0], two[0][1]);
#else
    float lane[3][16];
    for (uint k = 0; k < 16; ++k)
        for (uint axis = 0; axis < 3; ++axis) lane[axis][k] = vertex[4 * k + axis];
    for (uint axis = 0; axis < 3; ++axis)
        for (uint v = 0; v < RSH_VECTORS; ++v)
            row[axis][v] = load_lanes(lane[axis] + RSH_WIDTH * v);
#endif
}

/* order: 0 where triangles lie in their own. */
static void load_corners(rsh_mesh mesh, __global const float* vertices,
                         __global const uint* indices, __global const uint* order, uint first,
                         rsh_corner_rows* corners)
{
    float vertex[3][16 * 4];
    for (uint k = 0; k < 16; ++k) {
        const uint place = first + k;
        rsh_triangle p;
        if (place >= mesh.triangle_count ||
            !load_triangle(mesh, vertices, indices, order ? order[place] : place, &p))
            p.v0 = p.v1 = p.v2 = (float3)(NAN);
        vstore4((float4)(p.v0, 0.0f), k, vertex[0]);
        vstore4((float4)(p.v1, 0.0f), k, vertex[1]);
        vstore4((float4)(p.v2, 0.0f), k, vertex[2]);
    }
    for (uint i = 0; i < 3; ++i) transpose_vertices(vertex[i], corners->row[i]);
}

/* Boxes of 16 triangles, padded as box.h says, and the box around them. */
static void bound_triangles(const rsh_corner_rows* corners, __global float* group,
                            float* around)
{
    floatv low[3][RSH_VECTORS], high[3][RSH_VECTORS];
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        floatv largest = (floatv)(0.0f), sum = (floatv)(0.0f);
        for (uint axis = 0; axis < 3; ++axis) {
            const floatv a = corners->row[0][axis][v], b = corners->row[1][axis][v],
                         c = corners->row[2][axis][v];
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
            store_lanes(low[axis][v], group + 16 * axis + RSH_WIDTH * v);
            store_lanes(high[axis][v], group + 48 + 16 * axis + RSH_WIDTH * v);
        }
    }
    for (uint axis = 0; axis < 3; ++axis) {
        around[axis] = smallest_lane(low[axis]);
        around[3 + axis] = largest_lane(high[axis]);
    }
}

static void bound_cluster(rsh_mesh mesh, __global const float* vertices,
                          __global const uint* indices, __global const uint* order,
                          uint cluster, __global float* boxes, float* around)
{
    rsh_corner_rows corners;
    load_corners(mesh, vertices, indices, order, 16 * cluster, &corners);
    bound_triangles(&corners, boxes + RSH_GROUP_WORDS * cluster, around);
}

static float smallest_in_row(__global const float* row)
{
    floatv v[RSH_VECTORS];
    for (uint i = 0; i < RSH_VECTORS; ++i) v[i] = load_lanes(row + RSH_WIDTH * i);
    return smallest_lane(v);
}

static float largest_in_row(__global const float* row)
{
    floatv v[RSH_VECTORS];
    for (uint i = 0; i < RSH_VECTORS; ++i) v[i] = load_lanes(row + RSH_WIDTH * i);
    return largest_lane(v);
}

static void store_group(float row[6][16], __global float* group)
{
    for (uint f = 0; f < 6; ++f)
        for (uint v = 0; v < RSH_VECTORS; ++v)
            store_lanes(load_lanes(row[f] + RSH_WIDTH * v), group + 16 * f + RSH_WIDTH * v);
}

#endif
