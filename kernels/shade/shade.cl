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
    if (!RSH_TEXTURE) return (float3)(1.0f);
    if (texture >= images->texture_count) return (float3)(1.0f);
    uint corner[3];
    triangle_vertices(buffers->mesh, buffers->indices, hit.primitive, corner);
    const float2 uv = (1.0f - hit.u - hit.v) * vload2(corner[0], texcoords) +
                      hit.u * vload2(corner[1], texcoords) +
                      hit.v * vload2(corner[2], texcoords);
    return sample_image(images, texture, uv, false);
}

/* The materials, with their textures, of the lanes in `bits`. */
static void load_materials(const surface_buffers* buffers, const image_list* images,
                           __global const float* texcoords,
                           __global const rsh_material* materials, const ray_lanes* block,
                           const surface_lanes* surface, uint bits, material_lanes* lit)
{
    float row[13][RSH_WIDTH], u[RSH_WIDTH], v[RSH_WIDTH];
    store_lanes(block->u, u);
    store_lanes(block->v, v);
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        float3 emission = (float3)(0.0f), ambient = emission, diffuse = emission;
        float4 specular = (float4)(0.0f);
        if (bits >> k & 1) {
            __global const rsh_material* material = materials + surface->material[k];
            const rsh_hit hit = {0.0f, u[k], v[k], block->primitive[k]};
            const float3 texture =
                texture_colour(buffers, images, texcoords, hit, material->texture);
            emission = material->emission.xyz;
            ambient = material->ambient.xyz * texture;
            diffuse = material->diffuse.xyz * texture;
            specular = material->specular;
        }
        put_in_lane(emission, k, row);
        put_in_lane(ambient, k, row + 3);
        put_in_lane(diffuse, k, row + 6);
        put_in_lane(specular.xyz, k, row + 9);
        row[12][k] = fmax(specular.w, 0.0f);
    }
    lit->emission = load_v(row);
    lit->ambient = load_v(row + 3);
    lit->diffuse = load_v(row + 6);
    lit->specular = load_v(row + 9);
    lit->shininess = load_lanes(row[12]);
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

/* What the lanes without a surface see. */
static void see_environment(const image_list* images, uint image, float3 plain,
                            const ray_lanes* block, uint bits, float (*seen)[RSH_WIDTH])
{
    float row[3][RSH_WIDTH];
    if (RSH_ENVIRONMENT_IMAGE && bits) store_v(block->direction, row);
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        if (!(bits >> k & 1)) continue;
        float3 direction = (float3)(0.0f);
        if (RSH_ENVIRONMENT_IMAGE) direction = (float3)(row[0][k], row[1][k], row[2][k]);
        put_in_lane(environment_colour(images, image, plain, direction), k, seen);
    }
}

/* Adds what the lanes in `bits` see; the rest of the block becomes black if it is the first. */
static void add_colours(const uint* index, uint bits, __global const float4* weights,
                        float (*seen)[RSH_WIDTH], bool is_first, __global float4* colour)
{
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        const uint i = index[k];
        const bool is_seen = bits >> k & 1;
        if (i == RSH_NO_RAY || !(is_seen || is_first)) continue;
        float4 sum = colour[i];
        if (is_first) sum.xyz = (float3)(0.0f);
        const float3 weight = is_seen && weights ? weights[i].xyz : (float3)(1.0f);
        if (is_seen) sum.xyz += weight * (float3)(seen[0][k], seen[1][k], seen[2][k]);
        colour[i] = sum;
    }
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
        float seen[3][RSH_WIDTH];
        number_lanes(i, mine.end, index);
        load_rays(index, rays, hits, &block);
        const uint bits = RSH_LANE_BITS(block.is_active);
        const uint found = bits ? find_surfaces(&buffers, &block, bits, &surface) : 0;
        if (found) {
            const light_list near = {lights, light_count,
                                     hidden_lights(occlusion, index, found)};
            material_lanes lit;
            load_materials(&buffers, &images, texcoords, materials, &block, &surface, found,
                           &lit);
            store_v(sum_v(sum_v(lit.emission, product_v(lit.ambient, given_ambient)),
                          direct_light(&surface, &near, &lit, found)),
                    seen);
        }
        see_environment(&images, environment_image, environment.xyz, &block, bits & ~found,
                        seen);
        add_colours(index, bits, weights, seen, is_first, colour);
    }
}
