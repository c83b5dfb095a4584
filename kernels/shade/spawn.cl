/* spawn.cl - one mirror ray or one refracted ray per hit, see rsh_spawn.
 *   rays, hits, weights              in      weights NULL: all 1
 *   spawned_rays, spawned_weights    out     inactive, weight 0, where nothing is spawned
 *   spawned_skip                     out     the triangle that the ray leaves, or RSH_NO_HIT;
 *                                            may be NULL
 *   active_count                     in/out  grows by the active rays; may be NULL
 * Shadow rays are shade/spawn_shadow.cl's job, rays of both kinds, packed, that of shade/wave.cl.
 */
#include "lanes/stride.h"
#include "shade/branch.h"

__kernel void rsh_spawn(mesh_view mesh, __global const float* vertices,
                        __global const uint* indices, __global const float* normals,
                        __global const uint* material_ids,
                        __global const rsh_material* materials, uint material_count,
                        uint ray_count, uint is_refracted, float min_weight,
                        __global const rsh_ray* rays, __global const rsh_hit* hits,
                        __global const float4* weights, __global rsh_ray* spawned_rays,
                        __global float4* spawned_weights, __global uint* spawned_skip,
                        __global uint* active_count)
{
    const surface_buffers buffers = {mesh,    vertices,     indices,
                                     normals, material_ids, material_count};
    const uint kind = is_refracted ? RSH_REFRACTED : RSH_REFLECTED;
    const strided_range mine = my_elements(ray_count);
    uint active = 0;
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        rsh_ray spawned = inactive_ray();
        float3 weight = (float3)(0.0f);
        branching_hit at;
        const float3 seen = weights ? weights[i].xyz : (float3)(1.0f);
        if (find_branches(&buffers, materials, 1u << kind, seen, min_weight, rays[i], hits[i],
                          &at)) {
            const departure from = departure_of(&at.surface, rays[i], hits[i]);
            const rsh_ray ray = branch_ray(&buffers, materials, &at, &from, hits[i].primitive,
                                           kind, spawned_skip != 0);
            if (is_active(ray)) {
                spawned = ray;
                weight = at.weight[kind];
                ++active;
            }
        }
        spawned_rays[i] = spawned;
        spawned_weights[i] = (float4)(weight, 0.0f);
        store_skip(spawned_skip, i, spawned, hits[i]);
    }
    add_active(active_count, active);
}
