/* branch.h - which rays a hit sends on, a reflected and a refracted one at most, and these rays.
 * Knows nothing of where they are written.
 */
#ifndef RSH_SHADE_BRANCH_H
#define RSH_SHADE_BRANCH_H

#include "shade/fresnel.h"
#include "shade/grazing.h"
#include "shade/mirror.h"
#include "shade/spawned_ray.h"
#include "shade/types.h"

#ifndef RSH_TRANSMISSION
#define RSH_TRANSMISSION 1 /* 0: mirror rays need not know what transmits light */
#endif

/* A hit that sends rays on. */
typedef struct branching_hit {
    surface_hit surface;
    float3 weight[RSH_BRANCHES]; /* of the ray of each kind; 0: there is none */
} branching_hit;

static bool transmits(__global const rsh_material* material)
{
    return largest3(material->transmission.xyz) > 0.0f;
}

/* Most surfaces of most scenes send out no ray: known before their triangle is read. */
static bool may_branch(const surface_buffers* buffers, __global const rsh_material* materials,
                       rsh_hit hit, uint kinds)
{
    if (hit.primitive >= buffers->mesh.triangle_count) return false;
    __global const rsh_material* material = materials + material_of(buffers, hit.primitive);
    const bool may_transmit = RSH_TRANSMISSION || kinds >> RSH_REFRACTED & 1;
    if (may_transmit && transmits(material)) return true;
    return kinds >> RSH_REFLECTED & 1 && largest3(material->reflection.xyz) > 0.0f;
}

static float3 reflected_weight(const surface_hit* surface,
                               __global const rsh_material* material)
{
    if (!RSH_TRANSMISSION || !transmits(material)) return material->reflection.xyz;
    const float share = reflectance(dielectric_at(surface, material->transmission.w));
    return share + (1.0f - share) * material->reflection.xyz;
}

static float3 refracted_weight(const surface_hit* surface,
                               __global const rsh_material* material)
{
    if (!transmits(material)) return (float3)(0.0f);
    const dielectric at = dielectric_at(surface, material->transmission.w);
    return (1.0f - reflectance(at)) * material->transmission.xyz;
}

/* 0: whatever the ray saw, it would not change the image. */
static float3 worth(float3 weight, float min_weight)
{
    const bool is_worth = is_finite3(weight) && largest3(weight) > fmax(min_weight, 0.0f);
    return is_worth ? weight : (float3)(0.0f);
}

static bool has_branch(const branching_hit* at, uint kind)
{
    return largest3(at->weight[kind]) > 0.0f;
}

/* kinds: those asked for. weight: of the ray that hits. False: it sends none of them on. */
static bool find_branches(const surface_buffers* buffers,
                          __global const rsh_material* materials, uint kinds, float3 weight,
                          float min_weight, rsh_ray ray, rsh_hit hit, branching_hit* at)
{
    at->weight[RSH_REFLECTED] = at->weight[RSH_REFRACTED] = (float3)(0.0f);
    if (!may_branch(buffers, materials, hit, kinds)) return false;
    if (!find_surface(buffers, ray, hit, &at->surface)) return false;
    __global const rsh_material* material = materials + at->surface.material;
    if (kinds >> RSH_REFLECTED & 1)
        at->weight[RSH_REFLECTED] =
            worth(weight * reflected_weight(&at->surface, material), min_weight);
    if (kinds >> RSH_REFRACTED & 1)
        at->weight[RSH_REFRACTED] =
            worth(weight * refracted_weight(&at->surface, material), min_weight);
    return has_branch(at, RSH_REFLECTED) || has_branch(at, RSH_REFRACTED);
}

/* from: where the ray that hits meets the triangle. is_skipped: the ray that is sent on will not
 * hit it. */
static rsh_ray branch_ray(const surface_buffers* buffers,
                          __global const rsh_material* materials, const branching_hit* at,
                          const departure* from, uint triangle, uint kind, bool is_skipped)
{
    const surface_hit* surface = &at->surface;
    float3 side, direction;
    if (kind == RSH_REFRACTED) {
        const float index = materials[surface->material].transmission.w;
        side = -surface->geometric;
        direction = refract_ray(surface, dielectric_at(surface, index));
    } else {
        side = surface->geometric;
        direction = mirror_direction(buffers, surface, triangle, from);
    }
    direction = keep_on_side(direction, side);
    const twofold3 start = leave_surface(surface, from, side, is_skipped);
    return ray_from(rounded_to_side(start, side, direction), direction, INFINITY);
}

#endif
