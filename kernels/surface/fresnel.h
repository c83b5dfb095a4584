/* fresnel.h - how light splits at the surfaces of dielectrics (Born and Wolf, section 1.5). */
#ifndef RSH_SURFACE_FRESNEL_H
#define RSH_SURFACE_FRESNEL_H

#include "surface/surface.h"

typedef struct dielectric_lanes {
    floatv eta;       /* index of refraction behind the surface / before it                   */
    floatv cosine;    /* of the angle between viewer and normal; negative where an interpolated
                         normal faces away                                                    */
    floatv refracted; /* eta * cosine of the refracted angle; 0: total internal reflection    */
} dielectric_lanes;

/* Snell's law: sin = eta sin', hence (eta cos')^2 = eta^2 - sin^2 = (eta - 1)(eta + 1) + cos^2,
 * a form in which nothing cancels near eta = 1. An index that is not positive and finite counts
 * as 1. Beyond 2^60 nothing changes but that squares overflow: all light is reflected. */
static dielectric_lanes dielectrics_at(const surface_lanes* surface, floatv index)
{
    const floatv zero = (floatv)(0.0f), one = (floatv)(1.0f);
    dielectric_lanes at;
    index = select(one, index, (index > zero) & (index < (floatv)(INFINITY)));
    index = clamp(index, (floatv)(0x1p-60f), (floatv)(0x1p60f));
    at.eta = select(one / index, index, surface->is_outside);
    at.cosine = fmin(fmax(-dot_v(surface->incident, surface->normal), -one), one);
    at.refracted = sqrt(fmax((at.eta - one) * (at.eta + one) + at.cosine * at.cosine, zero));
    return at;
}

/* Mean of the reflectances of both polarizations. */
static floatv reflectance(const dielectric_lanes* at)
{
    const floatv cosine = fabs(at->cosine);
    const floatv across = (cosine - at->refracted) / (cosine + at->refracted);
    const floatv scaled = at->eta * at->eta * cosine;
    const floatv along = (scaled - at->refracted) / (scaled + at->refracted);
    const floatv mean = 0.5f * (across * across + along * along);
    return select((floatv)(1.0f), mean, at->refracted > (floatv)(0.0f));
}

/* Meaningless under total internal reflection, where its weight is 0. */
static float3v refracted_directions(const surface_lanes* surface, const dielectric_lanes* at)
{
    const float3v turn = scaled_v(at->cosine - at->refracted, surface->normal);
    return unit_v(sum_v(surface->incident, turn));
}

#endif
