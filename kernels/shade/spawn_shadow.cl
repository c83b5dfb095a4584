/* spawn_shadow.cl - one ray per hit towards one light, see rsh_spawn.
 *   rays, hits    in
 *   spawned_rays  out     inactive where the light could add nothing, or casts no shadow
 *   spawned_skip  out     the triangle that the ray leaves, or RSH_NO_HIT; may be NULL
 *   active_count  in/out  grows by the active rays; may be NULL
 */
#include "lanes/stride.h"
#include "shade/departure.h"
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

/* False also for a light closer to the surface than the origin's offset. */
static bool shadow_ray(rsh_light light, const surface_hit* surface, rsh_ray seen, rsh_hit hit,
                       bool is_skipped, rsh_ray* ray)
{
    light_arrival arrival;
    if (!light.casts_shadow || !light_arrives(light, surface, &arrival)) return false;
    const departure from = departure_of(surface, seen, hit);
    const float3 side = surface->geometric;
    const float3 origin = rounded_up(leave_surface(surface, &from, side, is_skipped), side);
    if (is_positional(light))
        *ray = ray_from(origin, light.position.xyz - origin, RSH_BEFORE_LIGHT);
    else
        *ray = ray_from(origin, arrival.direction, INFINITY);
    return is_active(*ray) &&
           dot3(surface->geometric, unit3(ray->direction_tmax.xyz)) > RSH_GRAZING;
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
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        rsh_ray ray;
        surface_hit surface;
        if (find_surface(&buffers, rays[i], hits[i], &surface) &&
            is_lit(materials + surface.material) &&
            shadow_ray(source, &surface, rays[i], hits[i], spawned_skip != 0, &ray))
            ++active;
        else
            ray = inactive_ray();
        spawned_rays[i] = ray;
        store_skip(spawned_skip, i, ray, hits[i]);
    }
    add_active(active_count, active);
}
