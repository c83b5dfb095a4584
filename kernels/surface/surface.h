/* surface.h - the points of surfaces that a block of RSH_WIDTH rays hits: where, which way they face,
 * of what they are. Which rays are in the block is the caller's to say. Computes no colour and no ray.
 */
#ifndef RSH_SURFACE_SURFACE_H
#define RSH_SURFACE_SURFACE_H

#include "lanes/rows.h"
#include "mesh/algebra_lanes.h"
#include "rays/types.h"
#include "surface/features.h"

/* The buffers of rsh_scene that say what the triangles are like. */
typedef struct surface_buffers {
    mesh_view mesh;
    __global const float* vertices;
    __global const uint* indices;
    __global const float* normals;
    __global const uint* material_ids;
    uint material_count;
} surface_buffers;

typedef struct ray_lanes {
    float3v origin, direction;
    floatv tmin, tmax;
    floatv t, u, v; /* of the hits */
    uint primitive[RSH_WIDTH];
    intv is_active; /* mask; lanes without a ray are not */
} ray_lanes;

/* As scaled_edges. */
typedef struct edge_lanes {
    twofold3v edge1, edge2;
    floatv extent, scale;
} edge_lanes;

typedef struct surface_lanes {
    float3v v0, v1, v2;
    edge_lanes edges;
    float3v point;     /* on the triangle                                                     */
    float3v geometric; /* unit normal of the triangle, turned to the side the ray comes from  */
    float3v normal;    /* unit, for shading, within 90 degrees of `geometric`                 */
    float3v incident;  /* unit direction of the ray                                           */
    intv is_outside;   /* mask: the ray comes from the side of (v1 - v0) x (v2 - v0)          */
    uint material[RSH_WIDTH];
    float3v vertex_normals[3]; /* if normals are interpolated                                 */
    uint features;             /* of the scene                                                */
} surface_lanes;

static uint material_of(const surface_buffers* buffers, uint triangle)
{
    const uint id = buffers->material_ids ? buffers->material_ids[triangle] : 0;
    return id < buffers->material_count ? id : 0;
}

static intv active_v(float3v origin, float3v direction, floatv tmin, floatv tmax)
{
    const floatv zero = (floatv)(0.0f);
    return is_finite_v(origin) & is_finite_v(direction) & (tmin <= tmax) &
           ((direction.x != zero) | (direction.y != zero) | (direction.z != zero));
}

static void store_v(float3v v, float (*row)[RSH_WIDTH])
{
    store_lanes(v.x, row[0]);
    store_lanes(v.y, row[1]);
    store_lanes(v.z, row[2]);
}

static void put_in_lane(float3 v, uint lane, float (*row)[RSH_WIDTH])
{
    row[0][lane] = v.x;
    row[1][lane] = v.y;
    row[2][lane] = v.z;
}

static float3v load_v(float (*row)[RSH_WIDTH])
{
    return (float3v){load_lanes(row[0]), load_lanes(row[1]), load_lanes(row[2])};
}

/* A bit for each lane that has a ray. */
static uint lanes_with_ray(const uint* index)
{
    return RSH_LANE_BITS(load_lanes(index) != (uintv)(RSH_NO_RAY));
}

/* The numbers of lanes in `bits`, one at least; in the others that of the first of these, so that all
 * lanes can be loaded. */
static void fill_lanes(uintv number, uint bits, uint* filled)
{
    store_lanes(number, filled);
    const uint first = filled[popcount((bits & -bits) - 1)];
    store_lanes(select((uintv)(first), number, mask_of_bits(bits)), filled);
}

/* RSH_WIDTH rays in a row; RSH_NO_RAY: from `end` on. */
static void number_lanes(uint first, uint end, uint* index)
{
    for (uint k = 0; k < RSH_WIDTH; ++k) index[k] = first + k < end ? first + k : RSH_NO_RAY;
}

/* A bit for each ray that hits a triangle: what else there is to know of a ray, most do not need. */
static uint lanes_with_hit(const uint* index, __global const rsh_hit* hits, uint triangle_count)
{
    uint bits = 0;
    for (uint k = 0; k < RSH_WIDTH; ++k)
        if (index[k] != RSH_NO_RAY)
            bits |= (uint)(hits[index[k]].primitive < triangle_count) << k;
    return bits;
}

/* The rays of these numbers (RSH_NO_RAY: none; not all of them) and their hits. */
RSH_CALLED static void load_rays(const uint* index, __global const rsh_ray* rays,
                                 __global const rsh_hit* hits, ray_lanes* block)
{
    uint filled[RSH_WIDTH];
    floatv origin[4], direction[4], hit[4];
    const uint bits = lanes_with_ray(index);
    const intv has_ray = mask_of_bits(bits);
    fill_lanes(load_lanes(index), bits, filled);
    load_rows4((__global const float*)rays, 8, filled, origin);
    load_rows4((__global const float*)rays + 4, 8, filled, direction);
    load_rows4((__global const float*)hits, 4, filled, hit);
    block->origin = (float3v){origin[0], origin[1], origin[2]};
    block->tmin = origin[3];
    block->direction = (float3v){direction[0], direction[1], direction[2]};
    block->tmax = direction[3];
    block->t = hit[0];
    block->u = hit[1];
    block->v = hit[2];
    store_lanes(select((uintv)(RSH_NO_HIT), as_uintv(hit[3]), has_ray), block->primitive);
    block->is_active =
        has_ray & active_v(block->origin, block->direction, block->tmin, block->tmax);
}

/* The weights of these rays (RSH_NO_RAY: none; not all of them); weights NULL: all 1. */
RSH_CALLED static float3v load_weights(const uint* index, __global const float4* weights)
{
    if (!weights) return lanes_of((float3)(1.0f));
    uint filled[RSH_WIDTH];
    floatv row[4];
    fill_lanes(load_lanes(index), lanes_with_ray(index), filled);
    load_rows4((__global const float*)weights, 4, filled, row);
    return (float3v){row[0], row[1], row[2]};
}

static edge_lanes edges_of_lanes(const surface_lanes* surface)
{
    edge_lanes edges;
    const float3v from = opposite_v(surface->v0), none = lanes_of((float3)(0.0f));
    const twofold3v a = exact_sum3_v(surface->v1, from), b = exact_sum3_v(surface->v2, from);
    edges.extent = fmax(largest_v(fabs_v(a.high)), largest_v(fabs_v(b.high)));
    const intv has_size = (edges.extent > (floatv)(0.0f)) & (edges.extent < (floatv)(INFINITY));
    const floatv scale = scale_to_one_v(edges.extent);
    edges.edge1.high = select_v(none, scaled_v(scale, a.high), has_size);
    edges.edge1.low = select_v(none, scaled_v(scale, a.low), has_size);
    edges.edge2.high = select_v(none, scaled_v(scale, b.high), has_size);
    edges.edge2.low = select_v(none, scaled_v(scale, b.low), has_size);
    edges.scale = select((floatv)(0.0f), scale, has_size);
    return edges;
}

/* Normals of triangles with counter-clockwise corners, within a few ulp also for slivers: the
 * rounding of the edges, which the cross product would magnify, is put back to first order. 0:
 * no area. */
static float3v triangle_normals(const edge_lanes* edges)
{
    const float3v a = edges->edge1.high, b = edges->edge2.high;
    return unit_v(sum_v(cross_v(a, b),
                        sum_v(cross_v(edges->edge1.low, b), cross_v(a, edges->edge2.low))));
}

/* Good enough to be lit; rays start at that of surface/departure.h. */
static float3v offset_from_v0(const surface_lanes* surface, const ray_lanes* block)
{
    return barycentric_offset_v(surface->v0, surface->v1, surface->v2, block->u, block->v);
}

/* Interpolated normals, turned to the side of `geometric`; zero or not finite: that one. Near
 * silhouettes they may still face away from the viewer. */
static float3v smooth_normals(const float3v* corner, const ray_lanes* block, float3v geometric)
{
    const floatv zero = (floatv)(0.0f);
    const float3v n = unit_v(sum_v(
        sum_v(scaled_v(1.0f - block->u - block->v, corner[0]), scaled_v(block->u, corner[1])),
        scaled_v(block->v, corner[2])));
    const float3v turned = select_v(n, opposite_v(n), dot_v(n, geometric) < zero);
    return select_v(geometric, turned, dot_v(n, n) > zero);
}

static float3v load_points(__global const float* points, uint stride, const uint* index)
{
    floatv row[3];
    load_rows3(points, stride, index, row);
    return (float3v){row[0], row[1], row[2]};
}

/* The vertices of the triangles of the lanes in `bits`, one at least, a row for each corner. Which of
 * them are there: none of whose vertices is out of range. */
static uint load_vertex_numbers(const surface_buffers* buffers, uintv triangle, uint bits,
                                uint (*corner)[RSH_WIDTH])
{
    const mesh_view mesh = buffers->mesh;
    uintv vertex[3] = {3u * triangle, 3u * triangle + 1u, 3u * triangle + 2u};
    if (mesh.is_indexed) {
        const ulong first = word_offset(mesh.indices_first_low, mesh.indices_first_high);
        floatv row[3];
        fill_lanes(triangle, bits, corner[0]);
        load_rows3((__global const float*)(buffers->indices + first), 3, corner[0], row);
        for (uint c = 0; c < 3; ++c) vertex[c] = as_uintv(row[c]);
    }
    const uintv count = (uintv)(mesh.vertex_count);
    bits &= RSH_LANE_BITS((vertex[0] < count) & (vertex[1] < count) & (vertex[2] < count));
    if (bits == 0) return 0;
    for (uint c = 0; c < 3; ++c) fill_lanes(vertex[c], bits, corner[c]);
    return bits;
}

static void load_vertex_normals(const surface_buffers* buffers, uint (*corner)[RSH_WIDTH],
                                surface_lanes* surface)
{
    const mesh_view mesh = buffers->mesh;
    __global const float* normals =
        buffers->normals + word_offset(mesh.normals_first_low, mesh.normals_first_high);
    for (uint c = 0; c < 3; ++c)
        surface->vertex_normals[c] = load_points(normals, mesh.normal_stride, corner[c]);
}

/* Reads the triangles, normals and materials of the lanes in `bits`; which of them are there. */
static uint load_surfaces(const surface_buffers* buffers, const ray_lanes* block, uint bits,
                          surface_lanes* surface)
{
    const mesh_view mesh = buffers->mesh;
    const uintv triangle = load_lanes(block->primitive);
    uint corner[3][RSH_WIDTH];
    bits &= RSH_LANE_BITS(triangle < (uintv)(mesh.triangle_count));
    if (bits) bits = load_vertex_numbers(buffers, triangle, bits, corner);
    if (bits == 0) return 0;
    __global const float* vertices =
        buffers->vertices + word_offset(mesh.vertices_first_low, mesh.vertices_first_high);
    surface->v0 = load_points(vertices, mesh.vertex_stride, corner[0]);
    surface->v1 = load_points(vertices, mesh.vertex_stride, corner[1]);
    surface->v2 = load_points(vertices, mesh.vertex_stride, corner[2]);
    if (has_smooth_normals(mesh.features)) load_vertex_normals(buffers, corner, surface);
    for (uint k = 0; k < RSH_WIDTH; ++k)
        surface->material[k] = bits >> k & 1 ? material_of(buffers, block->primitive[k]) : 0;
    return bits;
}

/* A member of the materials of all lanes; of_first: that of the first material. */
static void load_colours(__global const rsh_float4* of_first, const uint* material, floatv* row)
{
    load_rows4((__global const float*)of_first, sizeof(rsh_material) / sizeof(float), material,
               row);
}

/* Of the lanes in `bits`, a bit for each whose ray hits something that has a normal. */
RSH_CALLED static uint find_surfaces(const surface_buffers* buffers, const ray_lanes* block,
                                     uint bits, surface_lanes* surface)
{
    const floatv zero = (floatv)(0.0f);
    bits = load_surfaces(buffers, block, bits & RSH_LANE_BITS(block->is_active), surface);
    if (bits == 0) return 0;
    surface->edges = edges_of_lanes(surface);
    const float3v normal = triangle_normals(&surface->edges);
    surface->incident = unit_v(block->direction);
    surface->is_outside = dot_v(normal, surface->incident) <= zero;
    surface->geometric = select_v(opposite_v(normal), normal, surface->is_outside);
    surface->point = sum_v(surface->v0, offset_from_v0(surface, block));
    surface->features = buffers->mesh.features;
    surface->normal = has_smooth_normals(surface->features)
                          ? smooth_normals(surface->vertex_normals, block, surface->geometric)
                          : surface->geometric;
    return bits & RSH_LANE_BITS(dot_v(normal, normal) > zero);
}

#endif
