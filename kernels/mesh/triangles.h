/* triangles.h - reads triangles out of the caller's vertex and index buffers. */
#ifndef RSH_MESH_TRIANGLES_H
#define RSH_MESH_TRIANGLES_H

#include "lanes/lanes.h"
#include "mesh/types.h"

typedef struct triangle_points {
    float3 v0, v1, v2;
} triangle_points;

static ulong word_offset(uint low, uint high) { return ((ulong)high << 32) | low; }

/* Vertex numbers of a triangle; false when one is out of range. */
static bool triangle_vertices(mesh_view mesh, __global const uint* indices, uint triangle,
                              uint* corner)
{
    if (mesh.is_indexed) {
        const ulong first = word_offset(mesh.indices_first_low, mesh.indices_first_high);
        __global const uint* at = indices + first + 3ul * triangle;
        for (int i = 0; i < 3; ++i) corner[i] = at[i];
    } else {
        for (int i = 0; i < 3; ++i) corner[i] = 3 * triangle + i;
    }
    return corner[0] < mesh.vertex_count && corner[1] < mesh.vertex_count &&
           corner[2] < mesh.vertex_count;
}

static float3 vertex_position(mesh_view mesh, __global const float* vertices, uint vertex)
{
    return vload3(0, vertices + word_offset(mesh.vertices_first_low, mesh.vertices_first_high) +
                         (ulong)mesh.vertex_stride * vertex);
}

/* False: the triangle has an index out of range and is never hit; *out is NaN then, which every
 * test of mesh/intersect.h takes for a miss. */
static bool load_triangle(mesh_view mesh, __global const float* vertices,
                          __global const uint* indices, uint triangle, triangle_points* out)
{
    uint corner[3];
    if (!triangle_vertices(mesh, indices, triangle, corner)) {
        out->v0 = out->v1 = out->v2 = (float3)(NAN);
        return false;
    }
    out->v0 = vertex_position(mesh, vertices, corner[0]);
    out->v1 = vertex_position(mesh, vertices, corner[1]);
    out->v2 = vertex_position(mesh, vertices, corner[2]);
    return true;
}

static bool is_finite3(float3 v) { return isfinite(v.x) && isfinite(v.y) && isfinite(v.z); }

/* See rsh_ray: an inactive ray is in no node and hits nothing. */
static bool is_active(rsh_ray ray)
{
    return is_finite3(ray.origin_tmin.xyz) && is_finite3(ray.direction_tmax.xyz) &&
           (ray.direction_tmax.x != 0.0f || ray.direction_tmax.y != 0.0f ||
            ray.direction_tmax.z != 0.0f) &&
           ray.origin_tmin.w <= ray.direction_tmax.w;
}

/* Length without overflow or underflow in the squares; relative error below 2^-20 even where
 * divisions err by 2.5 and square roots by 3 ulp. Infinite if a component is not finite. */
static float safe_length(float3 v)
{
    const float scale = fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
    if (!is_finite3(v)) return INFINITY;
    if (!(scale > 0.0f)) return 0.0f;
    const float3 w = v / scale;
    return scale * sqrt(w.x * w.x + w.y * w.y + w.z * w.z);
}

#endif
