/* texture.h - reads images out of the texel buffer: linear colours, filtered between the four
 * nearest texel centres. No mipmaps.
 */
#ifndef RSH_SHADE_TEXTURE_H
#define RSH_SHADE_TEXTURE_H

#include "mesh/algebra.h"
#include "shade/srgb.h"

typedef struct image_list {
    __global const rsh_texture* textures;
    uint texture_count;
    __global const uint* texels;
} image_list;

static float3 texel(rsh_texture image, __global const uint* texels, int column, int row)
{
    const ulong index = (ulong)(uint)row * image.width + (uint)column;
    if (image.format == RSH_TEXEL_FLOAT32)
        return as_float3(vload3(0, texels + image.first_word + 4 * index));
    const uint code = texels[image.first_word + index];
    return (float3)(kLinearOfSrgb[code & 255], kLinearOfSrgb[(code >> 8) & 255],
                    kLinearOfSrgb[(code >> 16) & 255]);
}

/* Texel centres lie at (i + 0.5) / size, so `position` 0.5 is the first centre: lower and upper
 * neighbour, and the weight of the upper. `position` is within 0 .. size. */
typedef struct texel_neighbours {
    int low, high;
    float weight;
} texel_neighbours;

static texel_neighbours neighbours(float position, uint size, bool repeats)
{
    const int last = (int)size - 1;
    const float low = floor(position - 0.5f);
    texel_neighbours n = {(int)low, (int)low + 1, position - 0.5f - low};
    if (n.low < 0) n.low = repeats ? last : 0;
    if (n.high > last) n.high = repeats ? 0 : last;
    if (n.low > last) n.low = last;
    return n;
}

/* 0 .. 1, repeating or clamped; 0 for what is not finite, or no number. */
static float wrapped(float x, bool repeats)
{
    if (repeats) return isfinite(x) ? x - floor(x) : 0.0f;
    return fmin(fmax(x, 0.0f), 1.0f);
}

/* Rows run downwards from v = 1. The image around the scene repeats horizontally, as a sphere does.
 * White: there is no such image, or it has no texel. */
static float3 sample_image(const image_list* images, uint texture, float2 uv, bool is_around)
{
    if (texture >= images->texture_count) return (float3)(1.0f);
    const rsh_texture image = images->textures[texture];
    if (image.width == 0 || image.height == 0) return (float3)(1.0f);
    const bool in_u = is_around || image.wrap != RSH_WRAP_CLAMP;
    const bool in_v = !is_around && image.wrap != RSH_WRAP_CLAMP;
    const texel_neighbours x = neighbours(wrapped(uv.x, in_u) * image.width, image.width, in_u);
    const texel_neighbours y =
        neighbours((1.0f - wrapped(uv.y, in_v)) * image.height, image.height, in_v);
    __global const uint* texels = images->texels;
    const float3 upper = texel(image, texels, x.low, y.low) * (1.0f - x.weight) +
                         texel(image, texels, x.high, y.low) * x.weight;
    const float3 lower = texel(image, texels, x.low, y.high) * (1.0f - x.weight) +
                         texel(image, texels, x.high, y.high) * x.weight;
    return upper * (1.0f - y.weight) + lower * y.weight;
}

/* Latitude-longitude image: v = 1 looks along +y, the middle along -z, u grows towards +x. */
static float2 direction_to_uv(float3 d)
{
    return (float2)(0.5f + atan2(d.x, -d.z) * (0.5f * M_1_PI_F),
                    0.5f + atan2(d.y, sqrt(d.x * d.x + d.z * d.z)) * M_1_PI_F);
}

#endif
