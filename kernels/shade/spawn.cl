/* spawn.cl - one mirror ray or one refracted ray per hit, see rsh_spawn.
 *   rays, hits, weights              in      weights NULL: all 1
 *   spawned_rays, spawned_weights    out     inactive, weight 0, where nothing is spawned
 *   spawned_skip                     out     the triangle that the ray leaves, or RSH_NO_HIT;
 *                                            may be NULL
 *   active_count                     in/out  grows by the active rays; may be NULL
 * Shadow rays are shade/spawn_shadow.cl's job.
 */
#include "lanes/stride.h"
#include "shade/fresnel.h"
#include "shade/grazing.h"
#include "shade/mirror.h"
#include "shade/spawned_ray.h"

#ifndef RSH_TRANSMISSION
#define RSH_TRANSMISSION 1 /* 0: mirror rays need not know what transmits light */
#endif

typedef struct spawned_branch {
    float3 direction;
    float3 side; /* geometric normal, towards the side that the ray leaves to */
    float3 weight;
} spawned_branch;

static bool transmits(__global const rsh_material* material)
{
    return largest3(material->transmission.xyz) > 0.0f;
}

/* Most surfaces of most scenes send out no ray: known before their triangle is read. */
static bool may_branch(const surface_buffers* buffers, __global const rsh_material* materials,
                       rsh_hit hit, bool is_refracted)
{
    if (hit.primitive >= buffers->mesh.triangle_count) return false;
    __global const rsh_material* material = materials + material_of(buffers, hit.primitive);
    if (is_refracted) return transmits(material);
    if (RSH_TRANSMISSION && transmits(material)) return true;
    return largest3(material->reflection.xyz) > 0.0f;
}

static spawned_branch refracted_branch(const surface_hit* surface,
                                       __global const rsh_material* material)
{
    const float4 transmission = material->transmission;
    const dielectric at = dielectric_at(surface, transmission.w);
    spawned_branch branch;
    branch.side = -surface->geometric;
    branch.direction = keep_on_side(refract_ray(surface, at), branch.side);
    branch.weight = (1.0f - reflectance(at)) * transmission.xyz;
    return branch;
}

static spawned_branch reflected_branch(const surface_buffers* buffers,
                                       const surface_hit* surface, uint triangle,
                                       const departure* from,
                                       __global const rsh_material* material)
{
    spawned_branch branch;
    branch.side = surface->geometric;
    branch.direction =
        keep_on_side(mirror_direction(buffers, surface, triangle, from), branch.side);
    branch.weight = material->reflection.xyz;
    if (RSH_TRANSMISSION && transmits(material)) {
        const float share = reflectance(dielectric_at(surface, material->transmission.w));
        branch.weight = share + (1.0f - share) * branch.weight;
    }
    return branch;
}

/* False: whatever the ray saw, it would not change the image. */
static bool is_worth(float3 weight, float min_weight)
{
    return is_finite3(weight) && largest3(weight) > fmax(min_weight, 0.0f);
}

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
    const strided_range mine = my_elements(ray_count);
    uint active = 0;
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        rsh_ray spawned = inactive_ray();
        float3 weight = (float3)(0.0f);
        surface_hit surface;
        if (may_branch(&buffers, materials, hits[i], is_refracted) &&
            find_surface(&buffers, rays[i], hits[i], &surface)) {
            __global const rsh_material* material = materials + surface.material;
            const departure from = departure_of(&surface, rays[i], hits[i]);
            const spawned_branch branch =
                is_refracted
                    ? refracted_branch(&surface, material)
                    : reflected_branch(&buffers, &surface, hits[i].primitive, &from, material);
            const float3 product = weights ? weights[i].xyz * branch.weight : branch.weight;
            const twofold3 start =
                leave_surface(&surface, &from, branch.side, spawned_skip != 0);
            const rsh_ray ray = ray_from(rounded_to_side(start, branch.side, branch.direction),
                                         branch.direction, INFINITY);
            if (is_worth(product, min_weight) && is_active(ray)) {
                spawned = ray;
                weight = product;
                ++active;
            }
        }
        spawned_rays[i] = spawned;
        spawned_weights[i] = (float4)(weight, 0.0f);
        store_skip(spawned_skip, i, spawned, hits[i]);
    }
    add_active(active_count, active);
}
