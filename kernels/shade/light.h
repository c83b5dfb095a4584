/* light.h - the light of one lamp that reaches surfaces, a lane each, if nothing is in its way. The
 * same decision serves shading and shadow rays: no ray is cast where no light would arrive.
 */
#ifndef RSH_SHADE_LIGHT_H
#define RSH_SHADE_LIGHT_H

#include "surface/grazing.h"
#include "surface/surface.h"

typedef struct light_arrival {
    float3v direction; /* unit, from the surface to the light */
    float3v colour;    /* after attenuation and cone          */
} light_arrival;

static bool is_positional(rsh_light light)
{
    return light.kind == RSH_LIGHT_POINT || light.kind == RSH_LIGHT_SPOT;
}

/* Share of the light's colour left at a distance; none if the divisor is not positive. */
static floatv attenuated(float4 attenuation, floatv distance)
{
    const floatv zero = (floatv)(0.0f), one = (floatv)(1.0f);
    if (attenuation.x == 0.0f && attenuation.y == 0.0f && attenuation.z == 0.0f) return one;
    const floatv divisor =
        attenuation.x + attenuation.y * distance + attenuation.z * distance * distance;
    return select(zero, one / divisor, divisor > zero);
}

/* `cosine`: to the spot's axis. Compared in this order, equal limits are a hard edge. */
static floatv cone_share(rsh_light light, floatv cosine)
{
    const floatv zero = (floatv)(0.0f), one = (floatv)(1.0f);
    const floatv s = (cosine - light.cos_outer) / (light.cos_inner - light.cos_outer);
    const floatv between =
        select(zero, s * s * (3.0f - 2.0f * s), cosine > (floatv)(light.cos_outer));
    return select(between, one, cosine >= (floatv)(light.cos_inner));
}

/* Before it is known which way the surface faces. */
static light_arrival arrival_at(rsh_light light, float3v point)
{
    light_arrival arrival = {lanes_of((float3)(0.0f)), lanes_of(light.colour.xyz)};
    if (light.kind == RSH_LIGHT_DIRECTIONAL) {
        arrival.direction = lanes_of(unit3(-light.direction.xyz));
    } else if (is_positional(light)) {
        const float3v path = minus_v(lanes_of(light.position.xyz), point);
        arrival.direction = unit_v(path);
        arrival.colour =
            scaled_v(attenuated(light.attenuation, safe_length_v(path)), arrival.colour);
        if (light.kind == RSH_LIGHT_SPOT) {
            const float3v axis = lanes_of(unit3(light.direction.xyz));
            arrival.colour =
                scaled_v(cone_share(light, -dot_v(arrival.direction, axis)), arrival.colour);
        }
    }
    return arrival;
}

/* A mask. Not where the surface faces away from the light, is outside of its cone, or gets no
 * colour. */
static intv light_arrives(rsh_light light, const surface_lanes* surface, light_arrival* arrival)
{
    const floatv zero = (floatv)(0.0f);
    *arrival = arrival_at(light, surface->point);
    const intv is_ahead = dot_v(surface->geometric, arrival->direction) > (floatv)(RSH_GRAZING);
    const intv is_faced = dot_v(surface->normal, arrival->direction) > zero;
    const intv has_colour = largest_v(fabs_v(arrival->colour)) > zero;
    return is_ahead & is_faced & has_colour & is_finite_v(arrival->colour);
}

#endif
