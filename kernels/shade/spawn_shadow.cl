/* spawn_shadow.cl - one ray per hit towards one light, see rsh_spawn.
 *   rays, hits    in
 *   spawned_rays  out     inactive where the light could add nothing, or casts no shadow
 *   spawned_skip  out     the triangle that the ray leaves, or RSH_NO_HIT; may be NULL
 *   active_count  in/out  grows by the active rays; may be NULL
 */
#include "lanes/stride.h"
#include "rays/levels.h"
#include "shade/material.h"
#include "shade/shadow_ray.h"

/* Of the lanes in `bits`, those whose material sends light back. */
static uint lit_lanes(__global const rsh_material* materials, const surface_lanes* surface,
                      uint bits)
{
    floatv diffuse[4], specular[4];
    load_colours(&materials->diffuse, surface->material, diffuse);
    load_colours(&materials->specular, surface->material, specular);
    return bits &
           RSH_LANE_BITS(sends_light_back((float3v){diffuse[0], diffuse[1], diffuse[2]},
                                          (float3v){specular[0], specular[1], specular[2]}));
}

RSH_FILLS_VECTORS
__kernel void rsh_spawn_shadow(mesh_view mesh, __global const float* vertices,
                               __global const uint* indices, __global const float* normals,
                               __global const uint* material_ids,
                               __global const rsh_material* materials, uint material_count,
                               __global const rsh_light* lights, uint light, uint ray_count,
                               __global const uint* list_count, __global const rsh_ray* rays,
                               __global const rsh_hit* hits, __global rsh_ray* spawned_rays,
                               __global uint* spawned_skip, __global uint* active_count)
{
    const surface_buffers buffers = {mesh,    vertices,     indices,
                                     normals, material_ids, material_count};
    const rsh_light source = lights[light];
    const strided_range mine = my_blocks(counted_rays(ray_count, list_count));
    uint active = 0;
    for (uint i = mine.begin; i < mine.end; i += RSH_WIDTH * mine.step) {
        uint index[RSH_WIDTH];
        ray_lanes block;
        surface_lanes surface;
        sent_rays made;
        uint bits = 0;
        made.bits = 0;
        number_lanes(i, mine.end, index);
        if (source.casts_shadow) bits = lanes_with_hit(index, hits, mesh.triangle_count);
        if (bits) {
            load_rays(index, rays, hits, &block);
            bits = find_surfaces(&buffers, &block, bits, &surface);
            bits = lit_lanes(materials, &surface, bits);
        }
        if (bits) {
            light_arrival arrival;
            bits &= RSH_LANE_BITS(light_arrives(source, &surface, &arrival));
            made = send_to_light(source, &arrival, &surface, &block, bits, spawned_skip != 0);
        }
        store_sent_rays(&made, index, block.primitive, spawned_rays, spawned_skip);
        active += popcount(made.bits);
    }
    add_active(active_count, active);
}
