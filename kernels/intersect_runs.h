/* intersect_runs.h - the 16 rays of a block against triangles, one after the other; see
 * intersect_runs.cl. */
#ifndef RSH_INTERSECT_RUNS_H
#define RSH_INTERSECT_RUNS_H

#include "intersect.h"
#include "tile.h"

#ifndef RSH_VECTORS
#define RSH_VECTORS (16 / RSH_WIDTH)
#endif

typedef struct rsh_run_target {
    rsh_mesh mesh;
    __global const float* vertices;
    __global const uint* indices;
    __global const rsh_ray* rays;
    __global rsh_hit* hits;
    __global uint* occlusion;
    uint occlusion_bit; /* as a mask; 0: closest hits are wanted */
    __global const uint* order; /* triangles in the places that runs name; 0: their own */
} rsh_run_target;

/* tmax is lowered to the closest hit so far. */
typedef struct rsh_run_block {
    rsh_sheared ray[RSH_VECTORS];
    floatv u[RSH_VECTORS], v[RSH_VECTORS];
    uintv primitive[RSH_VECTORS];
    uint index[16];
    bool is_changed;
} rsh_run_block;

/* Rays outside of the grid, and inactive ones, get an empty interval. */
static void load_run_block(const rsh_run_target* target, rsh_tile tile, uint b,
                           rsh_run_block* block)
{
    float lanes[10][16];
    uint primitive[16];
    for (uint k = 0; k < 16; ++k) {
        const uint i = block->index[k] = ray_of(tile, b, k);
        const rsh_ray ray = target->rays[i == RSH_NO_RAY ? 0 : i];
        const bool is_used = i != RSH_NO_RAY && is_active(ray);
        float row[8];
        vstore8((float8)(ray.origin_tmin, ray.direction_tmax), 0, row);
        for (uint f = 0; f < 8; ++f) lanes[f][k] = row[f];
        lanes[8][k] = lanes[9][k] = 0.0f;
        primitive[k] = RSH_NO_HIT;
        if (!is_used) {
            lanes[7][k] = -1.0f;
        } else if (!target->occlusion_bit && target->hits[i].primitive != RSH_NO_HIT) {
            const rsh_hit hit = target->hits[i];
            lanes[7][k] = hit.t;
            lanes[8][k] = hit.u;
            lanes[9][k] = hit.v;
            primitive[k] = hit.primitive;
        }
    }
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const uint at = RSH_WIDTH * v;
        block->ray[v] = shear_rays(load_lanes(lanes[0] + at), load_lanes(lanes[1] + at),
                                   load_lanes(lanes[2] + at), load_lanes(lanes[4] + at),
                                   load_lanes(lanes[5] + at), load_lanes(lanes[6] + at),
                                   load_lanes(lanes[3] + at), load_lanes(lanes[7] + at));
        block->u[v] = load_lanes(lanes[8] + at);
        block->v[v] = load_lanes(lanes[9] + at);
        block->primitive[v] = load_lanes(primitive + at);
    }
    block->is_changed = false;
}

/* Of equal t the lower index wins, whatever the order. */
static void offer_triangle(const rsh_run_target* target, rsh_run_block* block, uint place)
{
    const uint triangle = target->order ? target->order[place] : place;
    rsh_triangle p;
    if (!load_triangle(target->mesh, target->vertices, target->indices, triangle, &p)) return;
    floatv corner[9];
    spread_triangle(p, corner);
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const rsh_hits hits = intersect(block->ray[v], corner);
        const intv is_better =
            hits.is_hit & ((hits.t < block->ray[v].tmax) |
                           ((uintv)(triangle) < block->primitive[v]));
        if (!any_lane(is_better)) continue;
        block->is_changed = true;
        block->ray[v].tmax = select(block->ray[v].tmax, hits.t, is_better);
        block->u[v] = select(block->u[v], hits.u, is_better);
        block->v[v] = select(block->v[v], hits.v, is_better);
        block->primitive[v] =
            select(block->primitive[v], (uintv)(triangle), as_uintv(is_better));
    }
}

static void store_run_block(const rsh_run_target* target, const rsh_run_block* block)
{
    if (!block->is_changed) return;
    float t[16], u[16], w[16];
    uint primitive[16];
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        store_lanes(block->ray[v].tmax, t + RSH_WIDTH * v);
        store_lanes(block->u[v], u + RSH_WIDTH * v);
        store_lanes(block->v[v], w + RSH_WIDTH * v);
        store_lanes(block->primitive[v], primitive + RSH_WIDTH * v);
    }
    for (uint k = 0; k < 16; ++k) {
        const uint i = block->index[k];
        if (i == RSH_NO_RAY || primitive[k] == RSH_NO_HIT) continue;
        if (target->occlusion_bit)
            target->occlusion[i] |= target->occlusion_bit;
        else
            target->hits[i] = (rsh_hit){t[k], u[k], w[k], primitive[k]};
    }
}

#endif
