/* shadow_ray.h - rays from surfaces to a light, for a block of hits. */
#ifndef RSH_SHADE_SHADOW_RAY_H
#define RSH_SHADE_SHADOW_RAY_H

#include "shade/light.h"
#include "surface/spawned_ray.h"
#include "surface/start.h"

/* End of a ray to a light at t = 1: a triangle that the light lies on, at most 11 times as wide
 * as the ray is long and not seen flatly, is found at 1 - 2^-16 or later: t errs by 20u of 12 times
 * the ray (mesh/intersect.h), 2^-16 is 256u. */
#define RSH_BEFORE_LIGHT (1.0f - 0x1p-16f)

/* Those that the lanes in `bits` send. None goes to a light closer to the surface than the origin's
 * offset. */
RSH_CALLED static sent_rays send_to_light(rsh_light light, const light_arrival* arrival,
                                          const surface_lanes* surface, const ray_lanes* block,
                                          uint bits, bool is_skipped)
{
    sent_rays made;
    made.bits = bits;
    if (bits == 0) return made;
    const departure_lanes from = departures_of(surface, block);
    const float3v side = surface->geometric;
    made.origin = rounded_up(leave_surfaces(surface, &from, side, is_skipped), side);
    made.direction = arrival->direction;
    made.tmax = INFINITY;
    if (is_positional(light)) {
        made.direction = minus_v(lanes_of(light.position.xyz), made.origin);
        made.tmax = RSH_BEFORE_LIGHT;
    }
    const floatv zero = (floatv)(0.0f);
    const intv is_made =
        active_v(made.origin, made.direction, zero, (floatv)(made.tmax)) &
        (dot_v(surface->geometric, unit_v(made.direction)) > (floatv)(RSH_GRAZING));
    made.bits &= RSH_LANE_BITS(is_made);
    return made;
}

#endif
