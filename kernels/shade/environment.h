/* environment.h - what a ray sees that hits nothing, where there is an image of the environment. */
#ifndef RSH_SHADE_ENVIRONMENT_H
#define RSH_SHADE_ENVIRONMENT_H

#include "mesh/algebra.h"
#include "shade/texture.h"

static float3 environment_colour(const image_list* images, uint image, float3 plain,
                                 float3 direction)
{
    const float2 uv = direction_to_uv(unit3(direction));
    return plain * sample_image(images, image, uv, true);
}

#endif
