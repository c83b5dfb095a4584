/* environment.h - what a ray sees that hits nothing. */
#ifndef RSH_SHADE_ENVIRONMENT_H
#define RSH_SHADE_ENVIRONMENT_H

#include "mesh/algebra.h"
#include "shade/texture.h"

#ifndef RSH_ENVIRONMENT_IMAGE
#define RSH_ENVIRONMENT_IMAGE 0
#endif

static float3 environment_colour(const image_list* images, uint image, float3 plain,
                                 float3 direction)
{
    if (!RSH_ENVIRONMENT_IMAGE) return plain;
    const float2 uv = direction_to_uv(unit3(direction));
    return plain * sample_image(images, image, uv, true);
}

#endif
