/* intersect_runs.h - the 16 rays of a block against the triangles of a run, one by one; see
 * traverse/paper/intersect_runs.cl. What earlier batches found is taken up again. */
#ifndef RSH_TRAVERSE_PAPER_INTERSECT_RUNS_H
#define RSH_TRAVERSE_PAPER_INTERSECT_RUNS_H

#include "bvh/layout.h"
#include "traverse/packet16.h"

typedef struct rsh_run_target {
    rsh_mesh mesh;
    __global const float* vertices;
    __global const uint* indices;
    __global const rsh_ray* rays;
    __global rsh_hit* hits;
    __global uint* occlusion;
    uint occlusion_bit;           /* as a mask; 0: closest hits are wanted */
    __global const float* bounds; /* runs name places in their clusters */
} rsh_run_target;

static void load_run_block(const rsh_run_target* target, rsh_tile tile, uint b,
                           rsh_block* block)
{
    load_block(block, tile, b, target->rays);
    if (target->occlusion_bit) return;
    for (uint k = 0; k < 16; ++k) {
        const uint i = ray_of(tile, b, k), v = k / RSH_WIDTH, lane = k % RSH_WIDTH;
        if (i == RSH_NO_RAY || target->hits[i].primitive == RSH_NO_HIT) continue;
        const rsh_hit hit = target->hits[i];
        ((float*)&block->ray[v].tmax)[lane] = hit.t;
        ((float*)&block->u[v])[lane] = hit.u;
        ((float*)&block->v[v])[lane] = hit.v;
        ((uint*)&block->primitive[v])[lane] = hit.primitive;
    }
}

/* True if a ray has a closer hit now. */
static bool offer_triangle(const rsh_run_target* target, rsh_block* block, uint place)
{
    const uint triangle = triangle_in_place(target->bounds, place);
    if (triangle == RSH_NO_HIT) return false;
    rsh_corners corners;
    fetch_corners(&corners, target->mesh, target->vertices, target->indices, triangle);
    return intersect_block(block, &corners, triangle, target->occlusion_bit != 0);
}

static void store_run_block(const rsh_run_target* target, rsh_tile tile, uint b,
                            const rsh_block* block)
{
    if (target->occlusion_bit)
        store_occlusion(block, tile, b, target->occlusion, target->occlusion_bit);
    else
        store_hits(block, tile, b, target->hits);
}

#endif
