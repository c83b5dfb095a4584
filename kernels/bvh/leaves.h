/* leaves.h - triangles, 16 at a time: their corners, the boxes around them, and where leaves
 * keep them. */
#ifndef RSH_BVH_LEAVES_H
#define RSH_BVH_LEAVES_H

#include "bvh/layout.h"
#include "mesh/boxes16.h"
#include "mesh/intersect.h"

/* Corners of 16 triangles, component by component, a lane each. */
typedef struct corner_rows {
    floatv row[3][3][RSH_VECTORS]; /* [corner][axis] */
} corner_rows;

/* A word per lane: base[stride * element]; each element is below count. */
static floatv gather_words(__global const float* base, uintv element, uint stride, uint count)
{
    if (count == 0) return (floatv)(INFINITY);
    uint number[RSH_WIDTH];
    float lane[RSH_WIDTH];
    store_lanes(element, number);
    for (uint k = 0; k < RSH_WIDTH; ++k) lane[k] = base[(ulong)stride * number[k]];
    return load_lanes(lane);
}

/* Indices of the triangles from place `first` on; order 0: places are indices. */
static uintv triangles_from(mesh_view mesh, __global const uint* order, uint first)
{
    const uintv places = as_uintv(RSH_LANES) + first;
    if (!order) return places;
    if (first + RSH_WIDTH <= mesh.triangle_count) return load_lanes(order + first);
    uint number[RSH_WIDTH];
    for (uint k = 0; k < RSH_WIDTH; ++k)
        number[k] = first + k < mesh.triangle_count ? order[first + k] : mesh.triangle_count;
    return load_lanes(number);
}

/* Corners of triangles, into vector v of `corners`. Those of a triangle that is never hit are
 * set to infinity: outside of every box, and a miss for mesh/intersect.h. */
static void load_corners_of(mesh_view mesh, __global const float* vertices,
                            __global const uint* indices, uintv triangle, uint v,
                            corner_rows* corners)
{
    __global const float* words = (__global const float*)indices +
                                  word_offset(mesh.indices_first_low, mesh.indices_first_high);
    vertices += word_offset(mesh.vertices_first_low, mesh.vertices_first_high);
    intv is_there = triangle < (uintv)(mesh.triangle_count);
    triangle = select((uintv)(0u), triangle, as_uintv(is_there));
    uintv vertex[3];
#pragma unroll
    for (uint i = 0; i < 3; ++i) {
        vertex[i] = mesh.is_indexed
                        ? as_uintv(gather_words(words + i, triangle, 3, mesh.triangle_count))
                        : 3u * triangle + i;
        is_there &= vertex[i] < (uintv)(mesh.vertex_count);
    }
    floatv sum = (floatv)(0.0f);
#pragma unroll
    for (uint i = 0; i < 9; ++i) {
        const uintv of = select((uintv)(0u), vertex[i / 3], as_uintv(is_there));
        const floatv c =
            gather_words(vertices + i % 3, of, mesh.vertex_stride, mesh.vertex_count);
        corners->row[i / 3][i % 3][v] = c;
        sum += c - c; /* 0, or NaN if any is not finite */
    }
    is_there &= sum == (floatv)(0.0f);
#pragma unroll
    for (uint i = 0; i < 9; ++i) {
        floatv* c = &corners->row[i / 3][i % 3][v];
        *c = select((floatv)(INFINITY), *c, is_there);
    }
}

#ifdef RSH_GATHER
/* The same for 16 triangles that are all sound, as nearly always: every vertex is there and
 * finite. Returns whether they are. RSH_GATHER takes signed word numbers. */
static bool load_sound_corners(mesh_view mesh, __global const float* vertices,
                               __global const uint* indices, uint16 triangle,
                               corner_rows* corners)
{
    if (mesh.vertex_count == 0) return false;
    if ((ulong)mesh.vertex_stride * mesh.vertex_count > INT_MAX) return false;
    const uint16 words = 3u * triangle; /* below 2^30 */
    __global const float* index = (__global const float*)indices +
                                  word_offset(mesh.indices_first_low, mesh.indices_first_high);
    vertices += word_offset(mesh.vertices_first_low, mesh.vertices_first_high);
    uint16 vertex[3];
    int16 is_missing = triangle >= (uint16)(mesh.triangle_count);
    if (any_lane(is_missing)) return false;
#pragma unroll
    for (uint i = 0; i < 3; ++i) {
        vertex[i] = mesh.is_indexed ? as_uint16(RSH_GATHER(index + i, words)) : words + i;
        is_missing |= vertex[i] >= (uint16)(mesh.vertex_count);
    }
    if (any_lane(is_missing)) return false;
    float16 sum = (float16)(0.0f);
#pragma unroll
    for (uint i = 0; i < 9; ++i) {
        const float16 c = RSH_GATHER(vertices + i % 3, vertex[i / 3] * mesh.vertex_stride);
        corners->row[i / 3][i % 3][0] = c;
        sum = fma(c, (float16)(0.0f), sum); /* 0, or NaN if any is not finite */
    }
    return !any_lane(sum != (float16)(0.0f));
}
#endif

static void load_corners(mesh_view mesh, __global const float* vertices,
                         __global const uint* indices, __global const uint* order, uint first,
                         corner_rows* corners)
{
#ifdef RSH_GATHER
    if (first + 16 <= mesh.triangle_count &&
        load_sound_corners(mesh, vertices, indices, triangles_from(mesh, order, first),
                           corners))
        return;
#endif
    for_each_vector(v)
        load_corners_of(mesh, vertices, indices,
                        triangles_from(mesh, order, first + RSH_WIDTH * v), v, corners);
}

/* The same for up to 16 triangles by their indices; where an index is out of range, at
 * infinity. */
static void load_numbered_corners(mesh_view mesh, __global const float* vertices,
                                  __global const uint* indices, const uintv* index,
                                  corner_rows* corners)
{
#ifdef RSH_GATHER
    const uint first = index[0].s0;
    const int16 is_there = index[0] < (uint16)(mesh.triangle_count);
    if (first < mesh.triangle_count &&
        load_sound_corners(mesh, vertices, indices,
                           select((uint16)(first), index[0], as_uint16(is_there)), corners)) {
#pragma unroll
        for (uint i = 0; i < 9; ++i) {
            floatv* c = &corners->row[i / 3][i % 3][0];
            *c = select((floatv)(INFINITY), *c, is_there);
        }
        return;
    }
#endif
    for_each_vector(v) load_corners_of(mesh, vertices, indices, index[v], v, corners);
}

/* Boxes of 16 triangles, not padded; empty for those that are never hit. */
static void boxes_of_corners(const corner_rows* corners, boxes16* boxes)
{
#pragma unroll
    for (uint axis = 0; axis < 3; ++axis)
        for_each_vector(v) {
            const floatv a = corners->row[0][axis][v], b = corners->row[1][axis][v],
                         c = corners->row[2][axis][v];
            const floatv high = greater(a, greater(b, c));
            boxes->low[axis][v] = lesser(a, lesser(b, c));
            boxes->high[axis][v] = select((floatv)(-INFINITY), high, high < (floatv)(INFINITY));
        }
}

/* Stores triangles with their indices. Returns whether mesh/intersect.h scales any of them. */
static bool store_triangles(const corner_rows* corners, const uintv* index,
                            __global float* leaf)
{
    uint scaled = 0;
    for_each_vector(v) {
        floatv corner[9];
#pragma unroll
        for (uint i = 0; i < 9; ++i) corner[i] = corners->row[i / 3][i % 3][v];
        const uintv places = put_lanes_in_order(corner);
#pragma unroll
        for (uint i = 0; i < 9; ++i)
            store_whole(__global, corner[i], leaf + 16 * i + RSH_WIDTH * v);
        store_whole_uint(__global, index[v] | places << RSH_PLACES_SHIFT,
                         leaf + RSH_TRIANGLES_AT + RSH_WIDTH * v);
        scaled |= RSH_LANE_BITS((triangle_scale(corner) != (floatv)(1.0f)) &
                                (corner[0] < (floatv)(INFINITY)));
    }
    return scaled != 0;
}

/* Asks for the cache lines of a leaf that will be written soon. */
static void expect_stores(__global const float* leaf)
{
#pragma unroll
    for (uint i = 0; i < 10; ++i) RSH_EXPECT_STORE(leaf + 16 * i);
}

/* Pads a box as rays/box_node.h derives. side: low x y z, high x y z. */
static void pad_box(float* side)
{
    if (!(side[0] <= side[3])) return; /* empty */
    float reach = 0.0f;
#pragma unroll
    for (uint f = 0; f < 6; ++f) {
        const float away = fabs(side[f]);
        reach = away > reach ? away : reach;
    }
    const float pad = pad_of(reach);
#pragma unroll
    for (uint f = 0; f < 6; ++f) side[f] += f < 3 ? -pad : pad;
}

/* Half the surface of a box; 0 if it is empty. */
static float surface_of(const float* low, const float* high)
{
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x >= 0.0f ? x * y + y * z + z * x : 0.0f;
}

#endif
