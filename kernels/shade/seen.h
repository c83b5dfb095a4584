/* seen.h - what a block of rays sees: of its surfaces themselves, of lights, of the environment; and the
 * colours that it is added to.
 */
#ifndef RSH_SHADE_SEEN_H
#define RSH_SHADE_SEEN_H

#include "shade/environment.h"
#include "shade/light.h"
#include "shade/material.h"

/* The buffers of rsh_scene that say what surfaces look like. */
typedef struct look_buffers {
    __global const float* texcoords;
    __global const rsh_material* materials;
    __global const rsh_light* lights;
    uint light_count;
    image_list images;
    float3 ambient, environment;
    uint environment_image;
    uint features; /* of the scene */
} look_buffers;

/* Where a block of rays ends: on surfaces, for the lanes in `found`. */
typedef struct seen_block {
    ray_lanes rays;
    surface_lanes surface;
    material_lanes lit;
    uint active, found; /* lane by lane */
} seen_block;

RSH_CALLED static void find_seen(const surface_buffers* buffers, const look_buffers* look,
                                 const uint* index, __global const rsh_ray* rays,
                                 __global const rsh_hit* hits, seen_block* block)
{
    load_rays(index, rays, hits, &block->rays);
    block->active = RSH_LANE_BITS(block->rays.is_active);
    block->found = 0;
    if (block->active)
        block->found = find_surfaces(buffers, &block->rays, block->active, &block->surface);
    if (!block->found) return;
    const float3v texture =
        texture_colours(buffers, &look->images, look->texcoords, look->materials, &block->rays,
                        &block->surface, block->found);
    load_materials(look->materials, &block->surface, texture, &block->lit);
}

/* What the lanes in `bits` see, which hit nothing. */
static float3v see_environment(const look_buffers* look, const ray_lanes* block, uint bits)
{
    if (!has_environment_image(look->features)) return lanes_of(look->environment);
    float row[3][RSH_WIDTH], seen[3][RSH_WIDTH];
    store_v(block->direction, row);
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        const float3 direction = {row[0][k], row[1][k], row[2][k]};
        float3 colour = (float3)(0.0f);
        if (bits >> k & 1)
            colour = environment_colour(&look->images, look->environment_image,
                                        look->environment, direction);
        put_in_lane(colour, k, seen);
    }
    return load_v(seen);
}

/* A light, as it arrives at the surfaces of a block. */
typedef struct seen_light {
    light_arrival arrival;
    uint bits;      /* lane by lane, whether it does */
    float3v colour; /* that it makes them send back */
} seen_light;

RSH_CALLED static seen_light see_light(const seen_block* block, rsh_light light, uint bits)
{
    seen_light seen;
    seen.colour = lanes_of((float3)(0.0f));
    const intv arrives = light_arrives(light, &block->surface, &seen.arrival);
    seen.bits = bits & RSH_LANE_BITS(arrives);
    if (seen.bits == 0) return seen;
    const float3v back =
        sent_back(&block->surface, seen.arrival.direction, &block->lit, seen.bits);
    seen.colour = select_v(seen.colour, product_v(seen.arrival.colour, back), arrives);
    return seen;
}

static uint open_lanes(uintv hidden, uint light)
{
    return RSH_LANE_BITS((hidden >> light & 1u) == (uintv)(0u));
}

/* What the active rays see but for the lights in the set `shadow_lights`. hidden: bit k, light k. */
RSH_CALLED static float3v see_all_but(const seen_block* block, const look_buffers* look,
                                      uint shadow_lights, uintv hidden)
{
    float3v seen = lanes_of((float3)(0.0f));
    if (block->found) {
        const material_lanes* lit = &block->lit;
        seen = sum_v(lit->emission, product_v(lit->ambient, lanes_of(look->ambient)));
        for (uint k = 0; k < look->light_count; ++k) {
            if (shadow_lights >> k & 1) continue;
            const uint bits = block->found & open_lanes(hidden, k);
            const seen_light light = see_light(block, look->lights[k], bits);
            seen = select_v(seen, sum_v(seen, light.colour), mask_of_bits(light.bits));
        }
    }
    const uint nothing = block->active & ~block->found;
    if (nothing)
        seen = select_v(see_environment(look, &block->rays, nothing), seen,
                        mask_of_bits(block->found));
    return seen;
}

/* Colours of a block of rays. */
typedef struct colour_lanes {
    floatv rgba[4];
} colour_lanes;

/* is_first: black, whatever is there. */
static colour_lanes load_sums(const uint* index, bool is_first, __global const float4* colour)
{
    uint filled[RSH_WIDTH];
    colour_lanes sums;
    fill_lanes(load_lanes(index), lanes_with_ray(index), filled);
    load_rows4((__global const float*)colour, 4, filled, sums.rgba);
    for (uint c = 0; is_first && c < 3; ++c) sums.rgba[c] = (floatv)(0.0f);
    return sums;
}

static void add_seen(float3v seen, uint bits, colour_lanes* sums)
{
    const intv is_seen = mask_of_bits(bits);
    sums->rgba[0] = select(sums->rgba[0], sums->rgba[0] + seen.x, is_seen);
    sums->rgba[1] = select(sums->rgba[1], sums->rgba[1] + seen.y, is_seen);
    sums->rgba[2] = select(sums->rgba[2], sums->rgba[2] + seen.z, is_seen);
}

static void store_sums(const colour_lanes* sums, const uint* index, __global float4* colour)
{
    store_rows4(sums->rgba, lanes_with_ray(index), (__global float*)colour, 4, index);
}

#endif
