/* wave.cl - from one wave of rays to the next one, and back. The next wave holds the reflected
 * rays of all hits, then the refracted ones, packed: those of a screen in the order of
 * shade/screen_order.h, those of a packed wave in its own.
 *   rays, hits, weights  in   a wave; weights NULL: all 1
 *   branches             out  of each ray, where those that it sends on stand in the next wave:
 *                             reflected, refracted; RSH_NO_RAY: none
 *   counts               of each work-item, the rays of either kind; then (reduce/scan_counts.cl)
 *                        where they begin
 * A work-item has a range of places, see ray_at_place.
 */
#include "lanes/stride.h"
#include "shade/branch.h"
#include "shade/screen_order.h"

static float3 weight_of(__global const float4* weights, uint ray)
{
    return weights ? weights[ray].xyz : (float3)(1.0f);
}

__kernel void rsh_wave_count(mesh_view mesh, __global const float* vertices,
                             __global const uint* indices, __global const float* normals,
                             __global const uint* material_ids,
                             __global const rsh_material* materials, uint material_count,
                             wave_part part, uint kinds, float min_weight,
                             __global const rsh_ray* rays, __global const rsh_hit* hits,
                             __global const float4* weights, __global uint2* branches,
                             __global uint* counts)
{
    const surface_buffers buffers = {mesh,    vertices,     indices,
                                     normals, material_ids, material_count};
    const uint me = get_global_id(0), items = get_global_size(0);
    const strided_range mine = my_range(part.count);
    uint2 sum = (uint2)(0);
    for (uint place = mine.begin; place < mine.end; ++place) {
        const uint i = ray_at_place(part, part.first + place);
        if (i == RSH_NO_RAY) continue;
        branching_hit at;
        uint2 branch = (uint2)(RSH_NO_RAY);
        if (find_branches(&buffers, materials, kinds, weight_of(weights, i), min_weight,
                          rays[i], hits[i], &at)) {
            if (has_branch(&at, RSH_REFLECTED)) branch.x = sum.x++;
            if (has_branch(&at, RSH_REFRACTED)) branch.y = sum.y++;
        }
        branches[i] = branch;
    }
    counts[me] = sum.x;
    counts[items + me] = sum.y;
}

/* What a work-item of rsh_wave_spawn writes to. */
typedef struct next_wave {
    __global rsh_ray* rays;
    __global float4* weights;
    __global uint* skip;
} next_wave;

static void store_branch(const next_wave* to, uint place, rsh_ray ray, float3 weight,
                         rsh_hit hit)
{
    const bool is_made = is_active(ray);
    to->rays[place] = is_made ? ray : inactive_ray();
    to->weights[place] = is_made ? (float4)(weight, 0.0f) : (float4)(0.0f);
    store_skip(to->skip, place, ray, hit);
}

__kernel void rsh_wave_spawn(mesh_view mesh, __global const float* vertices,
                             __global const uint* indices, __global const float* normals,
                             __global const uint* material_ids,
                             __global const rsh_material* materials, uint material_count,
                             wave_part part, uint kinds, float min_weight,
                             __global const rsh_ray* rays, __global const rsh_hit* hits,
                             __global const float4* weights, __global uint2* branches,
                             __global const uint* counts, __global rsh_ray* spawned_rays,
                             __global float4* spawned_weights, __global uint* spawned_skip)
{
    const surface_buffers buffers = {mesh,    vertices,     indices,
                                     normals, material_ids, material_count};
    const next_wave to = {spawned_rays, spawned_weights, spawned_skip};
    const uint me = get_global_id(0), items = get_global_size(0);
    const uint2 begin = (uint2)(counts[me], counts[items + me]);
    const strided_range mine = my_range(part.count);
    for (uint place = mine.begin; place < mine.end; ++place) {
        const uint i = ray_at_place(part, part.first + place);
        if (i == RSH_NO_RAY) continue;
        uint2 branch = branches[i];
        if (branch.x == RSH_NO_RAY && branch.y == RSH_NO_RAY) continue;
        const rsh_ray ray = rays[i];
        const rsh_hit hit = hits[i];
        branching_hit at;
        if (!find_branches(&buffers, materials, kinds, weight_of(weights, i), min_weight, ray,
                           hit, &at))
            continue;
        const departure from = departure_of(&at.surface, ray, hit);
        for (uint kind = 0; kind < RSH_BRANCHES; ++kind) {
            if (!has_branch(&at, kind)) continue;
            const uint to_place = kind ? (branch.y += begin.y) : (branch.x += begin.x);
            store_branch(&to, to_place,
                         branch_ray(&buffers, materials, &at, &from, hit.primitive, kind, true),
                         at.weight[kind], hit);
        }
        branches[i] = branch;
    }
}

/* Adds to the colour of each ray what those see that it sent on: reflected, then refracted, so
 * that the sum does not depend on how a wave is split up.
 *   next  in      colours of the next wave
 */
__kernel void rsh_wave_gather(wave_part part, __global const uint2* branches,
                              __global const float4* next, __global float4* colour)
{
    const strided_range mine = my_range(part.count);
    for (uint place = mine.begin; place < mine.end; ++place) {
        const uint i = ray_at_place(part, part.first + place);
        if (i == RSH_NO_RAY) continue;
        const uint2 branch = branches[i];
        if (branch.x != RSH_NO_RAY) colour[i].xyz += next[branch.x].xyz;
        if (branch.y != RSH_NO_RAY) colour[i].xyz += next[branch.y].xyz;
    }
}
