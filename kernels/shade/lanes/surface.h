/* surface.h - the surfaces that a block of RSH_WIDTH rays hits: shade/surface.h a lane each, with
 * the same bits. Which rays are in the block is the caller's to say. Computes no colour and no ray.
 */
#ifndef RSH_SHADE_LANES_SURFACE_H
#define RSH_SHADE_LANES_SURFACE_H

#include "mesh/algebra_lanes.h"
#include "rays/types.h"
#include "shade/surface.h"

typedef struct ray_lanes {
    float3v origin, direction;
    floatv tmin, tmax;
    floatv t, u, v; /* of the hits */
    uint primitive[RSH_WIDTH];
    intv is_active; /* mask; lanes without a ray are not */
} ray_lanes;

typedef struct edge_lanes {
    twofold3v edge1, edge2;
    floatv extent;
} edge_lanes;

/* As surface_hit. */
typedef struct surface_lanes {
    float3v v0, v1, v2;
    edge_lanes edges;
    float3v point, geometric, normal, incident;
    intv is_found; /* mask: the ray hits something that has a normal */
    uint material[RSH_WIDTH];
} surface_lanes;

static intv active_v(float3v origin, float3v direction, floatv tmin, floatv tmax)
{
    const floatv zero = (floatv)(0.0f);
    return is_finite_v(origin) & is_finite_v(direction) & (tmin <= tmax) &
           ((direction.x != zero) | (direction.y != zero) | (direction.z != zero));
}

static float3v load_v(float (*row)[RSH_WIDTH])
{
    return (float3v){load_lanes(row[0]), load_lanes(row[1]), load_lanes(row[2])};
}

static void store_v(float3v v, float (*row)[RSH_WIDTH])
{
    store_lanes(v.x, row[0]);
    store_lanes(v.y, row[1]);
    store_lanes(v.z, row[2]);
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

/* The rays of these numbers (RSH_NO_RAY: none) and their hits. */
static void load_rays(const uint* index, __global const rsh_ray* rays,
                      __global const rsh_hit* hits, ray_lanes* block)
{
    float row[11][RSH_WIDTH];
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        float ray[8];
        uint hit[4] = {0, 0, 0, RSH_NO_HIT};
        vstore8((float8)(0.0f), 0, ray);
        if (index[k] != RSH_NO_RAY) {
            vstore8(vload8(index[k], (__global const float*)rays), 0, ray);
            const rsh_hit at = hits[index[k]];
            hit[0] = as_uint(at.t), hit[1] = as_uint(at.u), hit[2] = as_uint(at.v);
            hit[3] = at.primitive;
        }
        for (uint f = 0; f < 8; ++f) row[f][k] = ray[f];
        for (uint f = 0; f < 3; ++f) row[8 + f][k] = as_float(hit[f]);
        block->primitive[k] = hit[3];
    }
    block->origin = load_v(row);
    block->tmin = load_lanes(row[3]);
    block->direction = load_v(row + 4);
    block->tmax = load_lanes(row[7]);
    block->t = load_lanes(row[8]);
    block->u = load_lanes(row[9]);
    block->v = load_lanes(row[10]);
    block->is_active = active_v(block->origin, block->direction, block->tmin, block->tmax);
}

static void put_in_lane(float3 v, uint lane, float (*row)[RSH_WIDTH])
{
    row[0][lane] = v.x;
    row[1][lane] = v.y;
    row[2][lane] = v.z;
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
    return edges;
}

static float3v offset_from_v0(const surface_lanes* surface, const ray_lanes* block)
{
    return sum_v(scaled_v(block->u, minus_v(surface->v1, surface->v0)),
                 scaled_v(block->v, minus_v(surface->v2, surface->v0)));
}

/* As smooth_normal; row: the normals of three corners. */
static float3v smooth_normal_v(float (*row)[RSH_WIDTH], const ray_lanes* block,
                               float3v geometric)
{
    const floatv zero = (floatv)(0.0f);
    const float3v n = unit_v(sum_v(sum_v(scaled_v(1.0f - block->u - block->v, load_v(row)),
                                         scaled_v(block->u, load_v(row + 3))),
                                   scaled_v(block->v, load_v(row + 6))));
    const float3v turned = select_v(n, opposite_v(n), dot_v(n, geometric) < zero);
    return select_v(geometric, turned, dot_v(n, n) > zero);
}

/* Reads the triangles, normals and materials of the lanes in `bits`; which of them are there. */
static uint load_surfaces(const surface_buffers* buffers, const ray_lanes* block, uint bits,
                          float (*row)[RSH_WIDTH], surface_lanes* surface)
{
    uint found = 0;
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        const uint triangle = block->primitive[k];
        uint corner[3] = {0, 0, 0};
        const bool is_there =
            bits >> k & 1 && triangle < buffers->mesh.triangle_count &&
            triangle_vertices(buffers->mesh, buffers->indices, triangle, corner);
        found |= (uint)is_there << k;
        for (uint c = 0; c < 3; ++c) {
            float3 at = (float3)(0.0f), normal = (float3)(0.0f);
            if (is_there) at = vertex_position(buffers->mesh, buffers->vertices, corner[c]);
            put_in_lane(at, k, row + 3 * c);
            if (!RSH_SMOOTH_NORMAL) continue;
            if (is_there) normal = vertex_normal(buffers, corner[c]);
            put_in_lane(normal, k, row + 9 + 3 * c);
        }
        surface->material[k] = is_there ? material_of(buffers, triangle) : 0;
    }
    return found;
}

/* The mask that has these bits. */
static intv lanes_of_bits(uint bits)
{
    return (((intv)((int)bits) >> RSH_LANES) & (intv)(1)) != (intv)(0);
}

/* Of the lanes in `bits`, a bit for each that is found. */
static uint find_surfaces(const surface_buffers* buffers, const ray_lanes* block, uint bits,
                          surface_lanes* surface)
{
    float row[18][RSH_WIDTH];
    const floatv zero = (floatv)(0.0f);
    bits = load_surfaces(buffers, block, bits & RSH_LANE_BITS(block->is_active), row, surface);
    surface->is_found = lanes_of_bits(bits);
    if (bits == 0) return 0;
    surface->v0 = load_v(row);
    surface->v1 = load_v(row + 3);
    surface->v2 = load_v(row + 6);
    surface->edges = edges_of_lanes(surface);
    const edge_lanes* edges = &surface->edges;
    const float3v a = edges->edge1.high, b = edges->edge2.high;
    const float3v normal = unit_v(sum_v(
        cross_v(a, b), sum_v(cross_v(edges->edge1.low, b), cross_v(a, edges->edge2.low))));
    surface->incident = unit_v(block->direction);
    surface->geometric =
        select_v(opposite_v(normal), normal, dot_v(normal, surface->incident) <= zero);
    surface->point = sum_v(surface->v0, offset_from_v0(surface, block));
    surface->normal = RSH_SMOOTH_NORMAL ? smooth_normal_v(row + 9, block, surface->geometric)
                                        : surface->geometric;
    surface->is_found &= dot_v(normal, normal) > zero;
    return bits & RSH_LANE_BITS(surface->is_found);
}

#endif
