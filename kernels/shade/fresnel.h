/* fresnel.h - how light splits at the surface of a dielectric (Born and Wolf, section 1.5). */
#ifndef RSH_SHADE_FRESNEL_H
#define RSH_SHADE_FRESNEL_H

#include "shade/surface.h"

typedef struct dielectric {
    float eta;       /* index of refraction behind the surface / before it                   */
    float cosine;    /* of the angle between viewer and normal; negative where an interpolated
                        normal faces away                                                    */
    float refracted; /* eta * cosine of the refracted angle; 0: total internal reflection     */
} dielectric;

/* Snell's law: sin = eta sin', hence (eta cos')^2 = eta^2 - sin^2 = (eta - 1)(eta + 1) + cos^2,
 * a form in which nothing cancels near eta = 1. An index that is not positive and finite counts
 * as 1. Beyond 2^60 nothing changes but that squares overflow: all light is reflected. */
static dielectric dielectric_at(const surface_hit* surface, float index)
{
    if (!(index > 0.0f) || isinf(index)) index = 1.0f;
    dielectric at;
    index = clamp(index, 0x1p-60f, 0x1p60f);
    at.eta = surface->is_outside ? index : 1.0f / index;
    at.cosine = fmin(fmax(-dot3(surface->incident, surface->normal), -1.0f), 1.0f);
    at.refracted = sqrt(fmax((at.eta - 1.0f) * (at.eta + 1.0f) + at.cosine * at.cosine, 0.0f));
    return at;
}

/* Mean of the reflectances of both polarizations. */
static float reflectance(dielectric at)
{
    if (!(at.refracted > 0.0f)) return 1.0f;
    const float cosine = fabs(at.cosine);
    const float across = (cosine - at.refracted) / (cosine + at.refracted);
    const float scaled = at.eta * at.eta * cosine;
    const float along = (scaled - at.refracted) / (scaled + at.refracted);
    return 0.5f * (across * across + along * along);
}

/* Meaningless under total internal reflection, where its weight is 0. */
static float3 refract_ray(const surface_hit* surface, dielectric at)
{
    return unit3(surface->incident + (at.cosine - at.refracted) * surface->normal);
}

#endif
