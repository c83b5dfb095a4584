/* branch.h - which rays the hits of a block send on, a reflected and a refracted one each at most, and
 * these rays. Knows nothing of where they are written.
 */
#ifndef RSH_SHADE_BRANCH_H
#define RSH_SHADE_BRANCH_H

#include "shade/types.h"
#include "surface/fresnel.h"
#include "surface/grazing.h"
#include "surface/mirror.h"
#include "surface/spawned_ray.h"
#include "surface/start.h"

/* Hits that send rays on. */
typedef struct branch_lanes {
    surface_lanes surface;
    dielectric_lanes glass;       /* where the material transmits light        */
    float3v weight[RSH_BRANCHES]; /* of the ray of each kind                   */
    uint bits[RSH_BRANCHES];      /* lane by lane, whether there is such a ray */
} branch_lanes;

/* Most surfaces of most scenes send out no ray: known before their triangle is read. */
static bool may_branch(const surface_buffers* buffers, __global const rsh_material* materials,
                       uint primitive, uint kinds)
{
    if (primitive >= buffers->mesh.triangle_count) return false;
    __global const rsh_material* material = materials + material_of(buffers, primitive);
    const bool may_transmit =
        has_transmission(buffers->mesh.features) || kinds >> RSH_REFRACTED & 1;
    if (may_transmit && largest3(material->transmission.xyz) > 0.0f) return true;
    return kinds >> RSH_REFLECTED & 1 && largest3(material->reflection.xyz) > 0.0f;
}

/* The lanes whose surface may send a ray on. */
static uint candidate_lanes(const surface_buffers* buffers,
                            __global const rsh_material* materials, uint kinds,
                            const uint* primitive)
{
    uint bits = 0;
    for (uint k = 0; k < RSH_WIDTH; ++k)
        bits |= (uint)may_branch(buffers, materials, primitive[k], kinds) << k;
    return bits;
}

/* What light each kind of ray brings to a viewer of weight 1. */
static void split_light(__global const rsh_material* materials, uint kinds, uint bits,
                        branch_lanes* at)
{
    floatv row[4];
    load_colours(&materials->reflection, at->surface.material, row);
    const float3v reflection = {row[0], row[1], row[2]};
    at->weight[RSH_REFLECTED] = reflection;
    at->weight[RSH_REFRACTED] = lanes_of((float3)(0.0f));
    const bool may_transmit = has_transmission(at->surface.features);
    if (!may_transmit && !(kinds >> RSH_REFRACTED & 1)) return;
    load_colours(&materials->transmission, at->surface.material, row);
    const float3v transmission = {row[0], row[1], row[2]};
    const intv transmits = largest_v(transmission) > (floatv)(0.0f);
    if (!(bits & RSH_LANE_BITS(transmits))) return;
    at->glass = dielectrics_at(&at->surface, row[3]);
    const floatv share = reflectance(&at->glass), rest = (floatv)(1.0f) - share;
    const float3v none = lanes_of((float3)(0.0f));
    const float3v both = sum_v((float3v){share, share, share}, scaled_v(rest, reflection));
    if (may_transmit) at->weight[RSH_REFLECTED] = select_v(reflection, both, transmits);
    at->weight[RSH_REFRACTED] = select_v(none, scaled_v(rest, transmission), transmits);
}

/* A bit for each weight that is worth a ray: whatever the others saw, it would not change the
 * image. */
static uint worth(float3v weight, float min_weight)
{
    const floatv least = (floatv)(fmax(min_weight, 0.0f));
    return RSH_LANE_BITS(is_finite_v(weight) & (largest_v(weight) > least));
}

/* kinds: those asked for. seen: weights of the rays that hit. Of the lanes in `bits`, those that send
 * a ray on. */
RSH_CALLED static uint find_branches(const surface_buffers* buffers,
                                     __global const rsh_material* materials, uint kinds,
                                     float3v seen, float min_weight, const ray_lanes* block,
                                     uint bits, branch_lanes* at)
{
    at->bits[RSH_REFLECTED] = at->bits[RSH_REFRACTED] = 0;
    bits = find_surfaces(buffers, block, bits, &at->surface);
    if (bits == 0) return 0;
    split_light(materials, kinds, bits, at);
    for (uint kind = 0; kind < RSH_BRANCHES; ++kind) {
        if (!(kinds >> kind & 1)) continue;
        at->weight[kind] = product_v(seen, at->weight[kind]);
        at->bits[kind] = bits & worth(at->weight[kind], min_weight);
    }
    return at->bits[RSH_REFLECTED] | at->bits[RSH_REFRACTED];
}

/* from: where the rays that hit meet their triangles. is_skipped: those that are sent on will not
 * hit them. */
RSH_CALLED static sent_rays send_branches(const branch_lanes* at, const departure_lanes* from,
                                          uint kind, bool is_skipped)
{
    const surface_lanes* surface = &at->surface;
    const bool is_refracted = kind == RSH_REFRACTED;
    const float3v side = is_refracted ? opposite_v(surface->geometric) : surface->geometric;
    const float3v aimed = is_refracted ? refracted_directions(surface, &at->glass)
                                       : mirror_directions(surface, from);
    sent_rays sent;
    sent.tmax = INFINITY;
    sent.direction = keep_on_side(aimed, side);
    const twofold3v start = leave_surfaces(surface, from, side, is_skipped);
    sent.origin = rounded_to_side(start, side, sent.direction);
    const intv is_made =
        active_v(sent.origin, sent.direction, (floatv)(0.0f), (floatv)(INFINITY));
    sent.bits = at->bits[kind] & RSH_LANE_BITS(is_made);
    return sent;
}

#endif
