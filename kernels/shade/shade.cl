/* shade.cl - what each ray sees, added to its colour, see rsh_shade.
 *   rays, hits, weights  in      weights NULL: all 1
 *   occlusion            in      bit k: light k is hidden; NULL: nothing is hidden
 *   colour               in/out  rgb grows, a stays; is_first: rgb only goes out
 * Mirrored and refracted light is added by shading the rays that shade/spawn.cl makes.
 */
#include "lanes/stride.h"
#include "shade/environment.h"
#include "shade/light.h"

#ifndef RSH_TEXTURE
#define RSH_TEXTURE 0
#endif

typedef struct light_list {
    __global const rsh_light* lights;
    uint count;
    uintv hidden; /* bit k: light k */
} light_list;

/* Of the materials of a block: what is lit. */
typedef struct material_lanes {
    float3v emission, ambient, diffuse, specular;
    floatv shininess;
    intv is_shiny;
} material_lanes;

static float3 texture_colour(const surface_buffers* buffers, const image_list* images,
                             __global const float* texcoords, rsh_hit hit, uint texture)
{
    if (texture >= images->texture_count) return (float3)(1.0f);
    uint corner[3];
    triangle_vertices(buffers->mesh, buffers->indices, hit.primitive, corner);
    const float2 uv = (1.0f - hit.u - hit.v) * vload2(corner[0], texcoords) +
                      hit.u * vload2(corner[1], texcoords) +
                      hit.v * vload2(corner[2], texcoords);
    return sample_image(images, texture, uv, false);
}

/* The texture colours of the lanes in `bits`. */
static float3v texture_colours(const surface_buffers* buffers, const image_list* images,
                               __global const float* texcoords,
                               __global const rsh_material* materials, const ray_lanes* block,
                               const surface_lanes* surface, uint bits)
{
    if (!RSH_TEXTURE) return lanes_of((float3)(1.0f));
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
    lit->diffuse = product_v((float3v){row[0], row[1], row[2]}, texture);
    load_colours(&materials->specular, surface->material, row);
    lit->specular = (float3v){row[0], row[1], row[2]};
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

static float3v direct_light(const surface_lanes* surface, const light_list* lights,
                            const material_lanes* lit, uint bits)
{
    float3v sum = lanes_of((float3)(0.0f));
    for (uint k = 0; k < lights->count; ++k) {
        light_arrival arrival;
        const intv is_open = ((lights->hidden >> k) & 1u) == (uintv)(0u);
        const intv arrives = is_open & light_arrives(lights->lights[k], surface, &arrival);
        const uint lanes = bits & RSH_LANE_BITS(arrives);
        if (lanes == 0) continue;
        const float3v back = sent_back(surface, arrival.direction, lit, lanes);
        sum = select_v(sum, sum_v(sum, product_v(arrival.colour, back)), arrives);
    }
    return sum;
}

/* What the lanes in `bits` see, which hit nothing. */
static float3v see_environment(const image_list* images, uint image, float3 plain,
                               const ray_lanes* block, uint bits)
{
    if (!RSH_ENVIRONMENT_IMAGE) return lanes_of(plain);
    float row[3][RSH_WIDTH], seen[3][RSH_WIDTH];
    store_v(block->direction, row);
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        const float3 direction = {row[0][k], row[1][k], row[2][k]};
        float3 colour = (float3)(0.0f);
        if (bits >> k & 1) colour = environment_colour(images, image, plain, direction);
        put_in_lane(colour, k, seen);
    }
    return load_v(seen);
}

/* Adds what the lanes in `bits` see; the rest of the block becomes black if it is the first. */
static void add_colours(const uint* index, uint bits, __global const float4* weights,
                        float3v seen, bool is_first, __global float4* colour)
{
    const uint all = lanes_with_ray(index);
    uint filled[RSH_WIDTH];
    floatv row[4];
    fill_lanes(load_lanes(index), all, filled);
    load_rows4((__global const float*)colour, 4, filled, row);
    const float3v none = lanes_of((float3)(0.0f));
    const float3v before = is_first ? none : (float3v){row[0], row[1], row[2]};
    if (weights) seen = product_v(load_weights(index, weights), seen);
    const float3v sum = select_v(before, sum_v(before, seen), lanes_of_bits(bits));
    row[0] = sum.x;
    row[1] = sum.y;
    row[2] = sum.z;
    store_rows4(row, is_first ? all : bits, (__global float*)colour, 4, index);
}

static uintv hidden_lights(__global const uint* occlusion, const uint* index, uint bits)
{
    uint hidden[RSH_WIDTH];
    for (uint k = 0; k < RSH_WIDTH; ++k)
        hidden[k] = occlusion && bits >> k & 1 ? occlusion[index[k]] : 0;
    return load_lanes(hidden);
}

__kernel void rsh_shade(mesh_view mesh, __global const float* vertices,
                        __global const uint* indices, __global const float* normals,
                        __global const float* texcoords, __global const uint* material_ids,
                        __global const rsh_material* materials, uint material_count,
                        __global const rsh_light* lights, uint light_count,
                        __global const rsh_texture* textures, uint texture_count,
                        __global const uint* texels, float4 ambient, float4 environment,
                        uint environment_image, uint ray_count, __global const rsh_ray* rays,
                        __global const rsh_hit* hits, __global const float4* weights,
                        __global const uint* occlusion, uint is_first, __global float4* colour)
{
    const surface_buffers buffers = {mesh,    vertices,     indices,
                                     normals, material_ids, material_count};
    const image_list images = {textures, texture_count, texels};
    const float3v given_ambient = lanes_of(ambient.xyz);
    const strided_range mine = my_elements(ray_count);
    for (uint i = mine.begin; i < mine.end; i += RSH_WIDTH * mine.step) {
        uint index[RSH_WIDTH];
        ray_lanes block;
        surface_lanes surface;
        float3v seen = lanes_of((float3)(0.0f));
        number_lanes(i, mine.end, index);
        load_rays(index, rays, hits, &block);
        const uint bits = RSH_LANE_BITS(block.is_active);
        const uint found = bits ? find_surfaces(&buffers, &block, bits, &surface) : 0;
        if (found) {
            const light_list near = {lights, light_count,
                                     hidden_lights(occlusion, index, found)};
            material_lanes lit;
            load_materials(materials, &surface,
                           texture_colours(&buffers, &images, texcoords, materials, &block,
                                           &surface, found),
                           &lit);
            seen = sum_v(sum_v(lit.emission, product_v(lit.ambient, given_ambient)),
                         direct_light(&surface, &near, &lit, found));
        }
        if (bits & ~found)
            seen = select_v(see_environment(&images, environment_image, environment.xyz, &block,
                                            bits & ~found),
                            seen, lanes_of_bits(found));
        add_colours(index, bits, weights, seen, is_first, colour);
    }
}
