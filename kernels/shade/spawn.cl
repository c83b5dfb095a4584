/* spawn.cl - one mirror ray or one refracted ray per hit, see rsh_spawn.
 *   rays, hits, weights              in      weights NULL: all 1
 *   spawned_rays, spawned_weights    out     inactive, weight 0, where nothing is spawned
 *   spawned_skip                     out     the triangle that the ray leaves, or RSH_NO_HIT;
 *                                            may be NULL
 *   active_count                     in/out  grows by the active rays; may be NULL
 * Shadow rays are shade/spawn_shadow.cl's job, rays of both kinds, packed, that of shade/wave.cl.
 */
#include "lanes/stride.h"
#include "rays/levels.h"
#include "shade/branch.h"

RSH_FILLS_VECTORS
__kernel void rsh_spawn(mesh_view mesh, __global const float* vertices,
                        __global const uint* indices, __global const float* normals,
                        __global const uint* material_ids,
                        __global const rsh_material* materials, uint material_count,
                        uint ray_count, __global const uint* list_count, uint is_refracted,
                        float min_weight, __global const rsh_ray* rays,
                        __global const rsh_hit* hits, __global const float4* weights,
                        __global rsh_ray* spawned_rays, __global float4* spawned_weights,
                        __global uint* spawned_skip, __global uint* active_count)
{
    const surface_buffers buffers = {mesh,    vertices,     indices,
                                     normals, material_ids, material_count};
    const uint kind = is_refracted ? RSH_REFRACTED : RSH_REFLECTED;
    const strided_range mine = my_blocks(counted_rays(ray_count, list_count));
    uint active = 0;
    for (uint i = mine.begin; i < mine.end; i += RSH_WIDTH * mine.step) {
        uint index[RSH_WIDTH];
        ray_lanes block;
        branch_lanes at;
        sent_rays sent;
        sent.bits = 0;
        number_lanes(i, mine.end, index);
        load_rays(index, rays, hits, &block);
        const uint bits = candidate_lanes(&buffers, materials, 1u << kind, block.primitive);
        if (bits && find_branches(&buffers, materials, 1u << kind, load_weights(index, weights),
                                  min_weight, &block, bits, &at)) {
            const departure_lanes from = departures_of(&at.surface, &block);
            sent = send_branches(&at, &from, kind, spawned_skip != 0);
        }
        store_sent_rays(&sent, index, block.primitive, spawned_rays, spawned_skip);
        store_sent_weights(at.weight[kind], sent.bits, index, spawned_weights);
        active += popcount(sent.bits);
    }
    add_active(active_count, active);
}
