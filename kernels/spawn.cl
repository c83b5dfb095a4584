/* spawn.cl - one mirror ray or one refracted ray per hit, see rsh_spawn.
 *   rays, hits, weights              in      weights NULL: all 1
 *   spawned_rays, spawned_weights    out     inactive, weight 0, where nothing is spawned
 *   active_count                     in/out  grows by the active rays; may be NULL
 * Shadow rays are spawn_shadow.cl's job.
 */
#include "fresnel.h"
#include "offset.h"
#include "spawned_ray.h"
#include "stride.h"

#ifndef RSH_REFRACTED
#define RSH_REFRACTED 0 /* 1: refracted rays, 0: mirror rays */
#endif
#ifndef RSH_TRANSMISSION
#define RSH_TRANSMISSION 1 /* 0: no material transmits light */
#endif

typedef struct rsh_branch {
    float3 direction;
    float3 side;
    float3 weight;
} rsh_branch;

static rsh_branch refracted_branch(const rsh_surface* surface,
                                   __global const rsh_material* material)
{
    const float4 transmission = material->transmission;
    const rsh_dielectric at = dielectric_at(surface, transmission.w);
    rsh_branch branch;
    branch.side = -surface->geometric;
    branch.direction = keep_on_side(refract_ray(surface, at), branch.side);
    branch.weight = (1.0f - reflectance(at)) * transmission.xyz;
    return branch;
}

static rsh_branch reflected_branch(const rsh_surface* surface,
                                   __global const rsh_material* material)
{
    rsh_branch branch;
    branch.side = surface->geometric;
    branch.direction = keep_on_side(reflect_ray(surface), branch.side);
    branch.weight = material->reflection.xyz;
#if RSH_TRANSMISSION
    const float4 transmission = material->transmission;
    if (largest3(transmission.xyz) > 0.0f) {
        const float share = reflectance(dielectric_at(surface, transmission.w));
        branch.weight = share + (1.0f - share) * branch.weight;
    }
#endif
    return branch;
}

/* True: the ray is worth tracing. */
static bool spawn_ray(const rsh_surface* surface, rsh_branch branch, float min_weight,
                      rsh_ray* ray)
{
    if (!is_finite3(branch.weight) || !(largest3(branch.weight) > fmax(min_weight, 0.0f)))
        return false;
    *ray = ray_from(leave_surface(surface, branch.side), branch.direction, INFINITY);
    return is_active(*ray);
}

__kernel void rsh_spawn(rsh_mesh mesh, __global const float* vertices,
                        __global const uint* indices, __global const float* normals,
                        __global const uint* material_ids,
                        __global const rsh_material* materials, uint material_count, uint ray_count, float min_weight,
                        __global const rsh_ray* rays, __global const rsh_hit* hits,
                        __global const float4* weights, __global rsh_ray* spawned_rays,
                        __global float4* spawned_weights, __global uint* active_count)
{
    const rsh_shape shape = {mesh, vertices, indices, normals, material_ids, material_count};
    const rsh_stride mine = my_elements(ray_count);
    uint active = 0;
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        rsh_ray ray = inactive_ray();
        float3 weight = (float3)(0.0f);
        rsh_surface surface;
        if (find_surface(&shape, rays[i], hits[i], &surface)) {
            __global const rsh_material* material = materials + surface.material;
#if RSH_REFRACTED
            rsh_branch branch = refracted_branch(&surface, material);
#else
            rsh_branch branch = reflected_branch(&surface, material);
#endif
            if (weights) branch.weight *= weights[i].xyz;
            if (spawn_ray(&surface, branch, min_weight, &ray)) {
                weight = branch.weight;
                ++active;
            } else {
                ray = inactive_ray();
            }
        }
        spawned_rays[i] = ray;
        spawned_weights[i] = (float4)(weight, 0.0f);
    }
    add_active(active_count, active);
}
