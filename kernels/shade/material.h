/* material.h - what the materials of a block of surfaces make of the light that reaches them. */
#ifndef RSH_SHADE_MATERIAL_H
#define RSH_SHADE_MATERIAL_H

#include "shade/texture.h"
#include "surface/surface.h"

/* Of the materials of a block: what is lit. */
typedef struct material_lanes {
    float3v emission, ambient, diffuse, specular;
    floatv shininess;
    intv is_shiny;
    intv sends_back; /* light of lamps, whatever the texture */
} material_lanes;

static intv sends_light_back(float3v diffuse, float3v specular)
{
    const floatv most = fmax(largest_v(fabs_v(diffuse)), largest_v(fabs_v(specular)));
    return most > (floatv)(0.0f);
}

static float2 texture_coordinates(const surface_buffers* buffers,
                                  __global const float* texcoords, rsh_hit hit)
{
    uint corner[3];
    triangle_vertices(buffers->mesh, buffers->indices, hit.primitive, corner);
    return (1.0f - hit.u - hit.v) * vload2(corner[0], texcoords) +
           hit.u * vload2(corner[1], texcoords) + hit.v * vload2(corner[2], texcoords);
}

static float3 texture_colour(const surface_buffers* buffers, const image_list* images,
                             __global const float* texcoords, rsh_hit hit, uint texture)
{
    if (texture >= images->texture_count) return (float3)(1.0f);
    return sample_image(images, texture, texture_coordinates(buffers, texcoords, hit), false);
}

/* The texture colours of the lanes in `bits`. */
static float3v texture_colours(const surface_buffers* buffers, const image_list* images,
                               __global const float* texcoords,
                               __global const rsh_material* materials, const ray_lanes* block,
                               const surface_lanes* surface, uint bits)
{
    if (!has_textures(buffers->mesh.features)) return lanes_of((float3)(1.0f));
    float row[3][RSH_WIDTH], u[RSH_WIDTH], v[RSH_WIDTH];
    store_lanes(block->u, u);
    store_lanes(block->v, v);
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        const rsh_hit hit = {0.0f, u[k], v[k], block->primitive[k]};
        float3 colour = (float3)(1.0f);
        if (bits >> k & 1)
            colour = texture_colour(buffers, images, texcoords, hit,
                                    materials[surface->material[k]].texture);
        put_in_lane(colour, k, row);
    }
    return load_v(row);
}

/* The materials of a block; texture: the colours of their textures. */
static void load_materials(__global const rsh_material* materials, const surface_lanes* surface,
                           float3v texture, material_lanes* lit)
{
    floatv row[4];
    load_colours(&materials->emission, surface->material, row);
    lit->emission = (float3v){row[0], row[1], row[2]};
    load_colours(&materials->ambient, surface->material, row);
    lit->ambient = product_v((float3v){row[0], row[1], row[2]}, texture);
    load_colours(&materials->diffuse, surface->material, row);
    const float3v diffuse = {row[0], row[1], row[2]};
    lit->diffuse = product_v(diffuse, texture);
    load_colours(&materials->specular, surface->material, row);
    lit->specular = (float3v){row[0], row[1], row[2]};
    lit->sends_back = sends_light_back(diffuse, lit->specular);
    lit->shininess = fmax(row[3], (floatv)(0.0f));
    lit->is_shiny = largest_v(fabs_v(lit->specular)) > (floatv)(0.0f);
}

/* cosine^exponent, of 0 .. 1 and 0 or more. With log2 and exp2 within 3 ulp, as OpenCL asks, it errs
 * by 2^-20 of itself where it is bright, by 2^-17 where it is 2^-20. PoCL's pow, which is good to some
 * ulp for any operands, took half of shading's time. */
static floatv power(floatv cosine, floatv exponent)
{
    return select((floatv)(1.0f), exp2(exponent * log2(cosine)), exponent > (floatv)(0.0f));
}

/* Blinn 1977: the highlight is where the normal lies halfway between light and viewer. */
static float3v sent_back(const surface_lanes* surface, float3v to_light,
                         const material_lanes* lit, uint bits)
{
    const float3v share = scaled_v(dot_v(surface->normal, to_light), lit->diffuse);
    bits &= RSH_LANE_BITS(lit->is_shiny);
    if (bits == 0) return share;
    const float3v halfway = unit_v(minus_v(to_light, surface->incident));
    const floatv cosine =
        fmin(fmax(dot_v(surface->normal, halfway), (floatv)(0.0f)), (floatv)(1.0f));
    const floatv highlight = power(cosine, lit->shininess);
    return select_v(share, sum_v(share, scaled_v(highlight, lit->specular)), lit->is_shiny);
}

#endif
