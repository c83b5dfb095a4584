/* spawn_shadow.cl - one ray per hit towards one light, see rsh_spawn.
 *   rays, hits    in
 *   spawned_rays  out     inactive where the light could add nothing, or casts no shadow
 *   spawned_skip  out     the triangle that the ray leaves, or RSH_NO_HIT; may be NULL
 *   active_count  in/out  grows by the active rays; may be NULL
 */
#include "lanes/stride.h"
#include "shade/light.h"
#include "shade/spawned_ray.h"
#include "shade/start.h"

/* End of a ray to a light at t = 1: a triangle that the light lies on, at most 11 times as wide
 * as the ray is long and not seen flatly, is found at 1 - 2^-16 or later: t errs by 20u of 12 times
 * the ray (mesh/intersect.h), 2^-16 is 256u. */
#define RSH_BEFORE_LIGHT (1.0f - 0x1p-16f)

/* Of the lanes in `bits`, those whose material sends light back. */
static uint lit_lanes(__global const rsh_material* materials, const surface_lanes* surface,
                      uint bits)
{
    floatv diffuse[4], specular[4];
    load_colours(&materials->diffuse, surface->material, diffuse);
    load_colours(&materials->specular, surface->material, specular);
    const floatv most =
        fmax(largest_v(fabs_v((float3v){diffuse[0], diffuse[1], diffuse[2]})),
             largest_v(fabs_v((float3v){specular[0], specular[1], specular[2]})));
    return bits & RSH_LANE_BITS(most > (floatv)(0.0f));
}

/* Those that the lanes in `bits` send. None goes to a light closer to the surface than the origin's
 * offset. */
static void send_to_light(rsh_light light, const surface_lanes* surface, const ray_lanes* block,
                          uint bits, bool is_skipped, sent_rays* made)
{
    light_arrival arrival;
    made->bits = bits & RSH_LANE_BITS(light_arrives(light, surface, &arrival));
    if (made->bits == 0) return;
    const departure_lanes from = departures_of(surface, block);
    const float3v side = surface->geometric;
    made->origin = rounded_up(leave_surfaces(surface, &from, side, is_skipped), side);
    made->direction = arrival.direction;
    made->tmax = INFINITY;
    if (is_positional(light)) {
        made->direction = minus_v(lanes_of(light.position.xyz), made->origin);
        made->tmax = RSH_BEFORE_LIGHT;
    }
    const floatv zero = (floatv)(0.0f);
    const intv is_made =
        active_v(made->origin, made->direction, zero, (floatv)(made->tmax)) &
        (dot_v(surface->geometric, unit_v(made->direction)) > (floatv)(RSH_GRAZING));
    made->bits &= RSH_LANE_BITS(is_made);
}

__kernel void rsh_spawn_shadow(mesh_view mesh, __global const float* vertices,
                               __global const uint* indices, __global const float* normals,
                               __global const uint* material_ids,
                               __global const rsh_material* materials, uint material_count,
                               __global const rsh_light* lights, uint light, uint ray_count,
                               __global const rsh_ray* rays, __global const rsh_hit* hits,
                               __global rsh_ray* spawned_rays, __global uint* spawned_skip,
                               __global uint* active_count)
{
    const surface_buffers buffers = {mesh,    vertices,     indices,
                                     normals, material_ids, material_count};
    const rsh_light source = lights[light];
    const strided_range mine = my_elements(ray_count);
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
        if (bits) send_to_light(source, &surface, &block, bits, spawned_skip != 0, &made);
        store_sent_rays(&made, index, block.primitive, spawned_rays, spawned_skip);
        active += popcount(made.bits);
    }
    add_active(active_count, active);
}
