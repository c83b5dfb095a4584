/* spawn_shadow.cl - one ray per hit towards one light, see rsh_spawn.
 *   rays, hits    in
 *   spawned_rays  out     inactive where the light could add nothing, or casts no shadow
 *   spawned_skip  out     the triangle that the ray leaves, or RSH_NO_HIT; may be NULL
 *   active_count  in/out  grows by the active rays; may be NULL
 */
#include "lanes/stride.h"
#include "shade/lanes/departure.h"
#include "shade/light.h"
#include "shade/spawned_ray.h"

/* End of a ray to a light at t = 1: a triangle that the light lies on, at most 11 times as wide
 * as the ray is long and not seen flatly, is found at 1 - 2^-16 or later: t errs by 20u of 12 times
 * the ray (mesh/intersect.h), 2^-16 is 256u. */
#define RSH_BEFORE_LIGHT (1.0f - 0x1p-16f)

static bool is_lit(__global const rsh_material* material)
{
    return largest3(fabs(material->diffuse.xyz)) > 0.0f ||
           largest3(fabs(material->specular.xyz)) > 0.0f;
}

/* What a block of hits sends towards a light. */
typedef struct shadow_rays {
    float3v origin, direction;
    float tmax;
} shadow_rays;

/* Those of the lanes in `bits` that send a ray, a bit each. None goes to a light closer to the
 * surface than the origin's offset. */
static uint find_shadow_rays(rsh_light light, const surface_lanes* surface,
                             const ray_lanes* block, uint bits, bool is_skipped,
                             shadow_rays* made)
{
    light_arrival arrival;
    bits &= RSH_LANE_BITS(light_arrives(light, surface, &arrival));
    if (bits == 0) return 0;
    const departure_lanes from = departures_of(surface, block);
    made->origin = rounded_starts(surface, &from, surface->geometric, is_skipped);
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
    return bits & RSH_LANE_BITS(is_made);
}

static uint lit_lanes(__global const rsh_material* materials, const surface_lanes* surface,
                      uint bits)
{
    uint lit = 0;
    for (uint k = 0; k < RSH_WIDTH; ++k)
        if (bits >> k & 1) lit |= (uint)is_lit(materials + surface->material[k]) << k;
    return lit;
}

static void store_shadow_rays(const shadow_rays* made, uint bits, const uint* index,
                              const uint* primitive, __global rsh_ray* rays,
                              __global uint* skip)
{
    float row[6][RSH_WIDTH];
    if (bits) {
        store_v(made->origin, row);
        store_v(made->direction, row + 3);
    }
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        if (index[k] == RSH_NO_RAY) continue;
        const bool is_made = bits >> k & 1;
        rsh_ray ray = inactive_ray();
        if (is_made)
            ray = ray_from((float3)(row[0][k], row[1][k], row[2][k]),
                           (float3)(row[3][k], row[4][k], row[5][k]), made->tmax);
        rays[index[k]] = ray;
        if (skip) skip[index[k]] = is_made ? primitive[k] : RSH_NO_HIT;
    }
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
        shadow_rays made;
        uint bits = 0;
        number_lanes(i, mine.end, index);
        if (source.casts_shadow) bits = lanes_with_hit(index, hits, mesh.triangle_count);
        if (bits) {
            load_rays(index, rays, hits, &block);
            bits = find_surfaces(&buffers, &block, bits, &surface);
            bits = lit_lanes(materials, &surface, bits);
        }
        if (bits)
            bits = find_shadow_rays(source, &surface, &block, bits, spawned_skip != 0, &made);
        store_shadow_rays(&made, bits, index, block.primitive, spawned_rays, spawned_skip);
        active += popcount(bits);
    }
    add_active(active_count, active);
}
