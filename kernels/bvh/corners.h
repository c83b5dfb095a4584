/* corners.h - the corners of 16 triangles out of the caller's mesh, a triangle per lane. */
#ifndef RSH_BVH_CORNERS_H
#define RSH_BVH_CORNERS_H

#include "mesh/boxes16.h"
#include "mesh/triangles.h"

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
#pragma unroll 1
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
#pragma unroll 1
    for (uint i = 0; i < 3; ++i) {
        vertex[i] = mesh.is_indexed
                        ? as_uintv(gather_words(words + i, triangle, 3, mesh.triangle_count))
                        : 3u * triangle + i;
        is_there &= vertex[i] < (uintv)(mesh.vertex_count);
    }
    floatv sum = (floatv)(0.0f);
#pragma unroll 1
    for (uint i = 0; i < 9; ++i) {
        const uintv of = select((uintv)(0u), vertex[i / 3], as_uintv(is_there));
        const floatv c =
            gather_words(vertices + i % 3, of, mesh.vertex_stride, mesh.vertex_count);
        corners->row[i / 3][i % 3][v] = c;
        sum += c - c; /* 0, or NaN if any is not finite */
    }
    is_there &= sum == (floatv)(0.0f);
#pragma unroll 1
    for (uint i = 0; i < 9; ++i) {
        floatv* c = &corners->row[i / 3][i % 3][v];
        *c = select((floatv)(INFINITY), *c, is_there);
    }
}

#if RSH_WIDTH > 1
/* The three words at each of sixteen places, a row each; read as four, in one instruction. */
static void load_threes(__global const float* words, const uint* place, float16* row)
{
#pragma unroll
    for (uint i = 0; i < 4; ++i)
        row[i] = (float16)(vload4(0, words + place[i]), vload4(0, words + place[4 + i]),
                           vload4(0, words + place[8 + i]), vload4(0, words + place[12 + i]));
    transpose_fours(row);
}

/* [corner]. Of triangles before the mesh's last one. */
static void load_vertices_of(mesh_view mesh, __global const uint* indices,
                             const uintv* triangle, uintv vertex[3][RSH_VECTORS])
{
    uint place[16];
    for_each_vector(v) {
        const uintv first = 3u * triangle[v]; /* below 2^30 */
        store_lanes(first, place + RSH_WIDTH * v);
        for (uint i = 0; i < 3; ++i) vertex[i][v] = first + i;
    }
    if (!mesh.is_indexed) return;
    float16 row[4];
    load_threes((__global const float*)indices +
                    word_offset(mesh.indices_first_low, mesh.indices_first_high),
                place, row);
    for (uint i = 0; i < 3; ++i) take_uints_apart(as_uint16(row[i]), vertex[i]);
}

static bool any_from(uint end, const uintv* element)
{
    intv is_from = (intv)(0);
    for_each_vector(v) is_from |= element[v] >= (uintv)(end);
    return any_lane(is_from);
}

/* Corners of 16 triangles that are all sound, as nearly always: every vertex is there and finite.
 * Returns whether they are. The last triangle and the last vertex count as unsound: there may be
 * no fourth word behind their three. */
static bool load_sound_corners(mesh_view mesh, __global const float* vertices,
                               __global const uint* indices, const uintv* triangle,
                               corner_rows* corners)
{
    if (mesh.triangle_count == 0 || mesh.vertex_count == 0) return false;
    if ((ulong)mesh.vertex_stride * mesh.vertex_count > UINT_MAX) return false;
    if (any_from(mesh.triangle_count - 1, triangle)) return false;
    uintv vertex[3][RSH_VECTORS];
    load_vertices_of(mesh, indices, triangle, vertex);
    vertices += word_offset(mesh.vertices_first_low, mesh.vertices_first_high);
    float16 sum = (float16)(0.0f);
#pragma unroll 1
    for (uint i = 0; i < 3; ++i) {
        if (any_from(mesh.vertex_count - 1, vertex[i])) return false;
        uint place[16];
        for_each_vector(v)
            store_lanes(vertex[i][v] * mesh.vertex_stride, place + RSH_WIDTH * v);
        float16 row[4];
        load_threes(vertices, place, row);
#pragma unroll
        for (uint axis = 0; axis < 3; ++axis) {
            take_apart(row[axis], corners->row[i][axis]);
            sum = fma(row[axis], (float16)(0.0f), sum); /* 0, or NaN if any is not finite */
        }
    }
    floatv sums[RSH_VECTORS];
    take_apart(sum, sums);
    intv is_broken = (intv)(0);
    for_each_vector(v) is_broken |= sums[v] != (floatv)(0.0f);
    return !any_lane(is_broken);
}
#endif

RSH_CALLED static void load_corners(mesh_view mesh, __global const float* vertices,
                                    __global const uint* indices, __global const uint* order,
                                    uint first, corner_rows* corners)
{
#if RSH_WIDTH > 1
    uintv triangle[RSH_VECTORS];
    for_each_vector(v) triangle[v] = triangles_from(mesh, order, first + RSH_WIDTH * v);
    if (load_sound_corners(mesh, vertices, indices, triangle, corners)) return;
#endif
    for_each_vector(v)
        load_corners_of(mesh, vertices, indices,
                        triangles_from(mesh, order, first + RSH_WIDTH * v), v, corners);
}

/* The same for up to 16 triangles by their indices; where an index is out of range, at
 * infinity. */
RSH_CALLED static void load_numbered_corners(mesh_view mesh, __global const float* vertices,
                                             __global const uint* indices, const uintv* index,
                                             corner_rows* corners)
{
#if RSH_WIDTH > 1
    intv is_there[RSH_VECTORS];
    uintv triangle[RSH_VECTORS];
    for_each_vector(v) {
        is_there[v] = index[v] < (uintv)(mesh.triangle_count);
        triangle[v] = select((uintv)(index[0].s0), index[v], as_uintv(is_there[v]));
    }
    if (load_sound_corners(mesh, vertices, indices, triangle, corners)) {
#pragma unroll
        for (uint i = 0; i < 9; ++i)
            for_each_vector(v) {
                floatv* c = &corners->row[i / 3][i % 3][v];
                *c = select((floatv)(INFINITY), *c, is_there[v]);
            }
        return;
    }
#endif
    for_each_vector(v) load_corners_of(mesh, vertices, indices, index[v], v, corners);
}

#endif
