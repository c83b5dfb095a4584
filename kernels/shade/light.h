/* light.h - the light of one lamp that reaches a surface, if nothing is in its way. The same
 * decision serves shading and shadow rays: no ray is cast where no light would arrive.
 */
#ifndef RSH_SHADE_LIGHT_H
#define RSH_SHADE_LIGHT_H

#include "shade/grazing.h"
#include "shade/surface.h"

typedef struct light_arrival {
    float3 direction; /* unit, from the surface to the light */
    float3 colour;    /* after attenuation and cone          */
} light_arrival;

static bool is_positional(rsh_light light)
{
    return light.kind == RSH_LIGHT_POINT || light.kind == RSH_LIGHT_SPOT;
}

/* Share of the light's colour left at a distance; none if the divisor is not positive. */
static float attenuated(float4 attenuation, float distance)
{
    if (attenuation.x == 0.0f && attenuation.y == 0.0f && attenuation.z == 0.0f) return 1.0f;
    const float divisor =
        attenuation.x + attenuation.y * distance + attenuation.z * distance * distance;
    return divisor > 0.0f ? 1.0f / divisor : 0.0f;
}

/* `cosine`: to the spot's axis. Compared in this order, equal limits are a hard edge. */
static float cone_share(rsh_light light, float cosine)
{
    if (cosine >= light.cos_inner) return 1.0f;
    if (!(cosine > light.cos_outer)) return 0.0f;
    const float s = (cosine - light.cos_outer) / (light.cos_inner - light.cos_outer);
    return s * s * (3.0f - 2.0f * s);
}

/* Before it is known which way the surface faces. */
static light_arrival arrival_at(rsh_light light, float3 point)
{
    light_arrival arrival = {(float3)(0.0f), light.colour.xyz};
    if (light.kind == RSH_LIGHT_DIRECTIONAL) {
        arrival.direction = unit3(-light.direction.xyz);
    } else if (is_positional(light)) {
        const float3 path = light.position.xyz - point;
        arrival.direction = unit3(path);
        arrival.colour *= attenuated(light.attenuation, safe_length(path));
        if (light.kind == RSH_LIGHT_SPOT)
            arrival.colour *=
                cone_share(light, -dot3(arrival.direction, unit3(light.direction.xyz)));
    }
    return arrival;
}

/* False: the surface faces away from the light, is outside of its cone, or gets no colour. */
static bool light_arrives(rsh_light light, const surface_hit* surface, light_arrival* arrival)
{
    *arrival = arrival_at(light, surface->point);
    return dot3(surface->geometric, arrival->direction) > RSH_GRAZING &&
           dot3(surface->normal, arrival->direction) > 0.0f && is_finite3(arrival->colour) &&
           largest3(fabs(arrival->colour)) > 0.0f;
}

#endif
