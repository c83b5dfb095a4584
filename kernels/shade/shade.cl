/* shade.cl - what each ray sees, added to its colour, see rsh_shade.
 *   rays, hits, weights  in      weights NULL: all 1
 *   occlusion            in      bit k: light k is hidden; NULL: nothing is hidden
 *   colour               in/out  rgb grows, a stays; is_first: rgb only goes out
 * Mirrored and refracted light is added by shading the rays that shade/spawn.cl makes.
 */
#include "shade/environment.h"
#include "shade/light.h"

#ifndef RSH_TEXTURE
#define RSH_TEXTURE 0
#endif

typedef struct light_list {
    __global const rsh_light* lights;
    uint count;
    uint hidden; /* bit k: light k */
} light_list;

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

/* cosine^exponent, of 0 .. 1 and 0 or more. With log2 and exp2 within 3 ulp, as OpenCL asks, it errs
 * by 2^-20 of itself where it is bright, by 2^-17 where it is 2^-20. Half of shading's time went into
 * PoCL's pow, which is good to some ulp for any operands. */
static float power(float cosine, float exponent)
{
    return exponent > 0.0f ? exp2(exponent * log2(cosine)) : 1.0f;
}

/* Blinn 1977: the highlight is where the normal lies halfway between light and viewer. */
static float3 sent_back(const surface_hit* surface, float3 to_light, float3 diffuse,
                        float4 specular)
{
    float3 share = diffuse * dot3(surface->normal, to_light);
    if (largest3(fabs(specular.xyz)) > 0.0f) {
        const float3 halfway = unit3(to_light - surface->incident);
        const float cosine = fmin(fmax(dot3(surface->normal, halfway), 0.0f), 1.0f);
        share += specular.xyz * power(cosine, specular.w);
    }
    return share;
}

static float3 direct_light(const surface_hit* surface, const light_list* lights, float3 diffuse,
                           float4 specular)
{
    float3 sum = (float3)(0.0f);
    for (uint k = 0; k < lights->count; ++k) {
        light_arrival arrival;
        if (lights->hidden >> k & 1) continue;
        if (!light_arrives(lights->lights[k], surface, &arrival)) continue;
        sum += arrival.colour * sent_back(surface, arrival.direction, diffuse, specular);
    }
    return sum;
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
    const uint i = get_global_id(0);
    if (i >= ray_count) return;
    if (is_first) colour[i].xyz = (float3)(0.0f);
    if (!is_active(rays[i])) return;
    const float3 weight = weights ? weights[i].xyz : (float3)(1.0f);
    const surface_buffers buffers = {mesh,    vertices,     indices,
                                     normals, material_ids, material_count};
    const image_list images = {textures, texture_count, texels};
    const rsh_hit hit = hits[i];

    surface_hit surface;
    float3 seen;
    if (find_surface(&buffers, rays[i], hit, &surface)) {
        const rsh_material material = materials[surface.material];
        const light_list near = {lights, light_count, occlusion ? occlusion[i] : 0};
        const float3 texture =
            texture_colour(&buffers, &images, texcoords, hit, material.texture);
        seen = material.emission.xyz + material.ambient.xyz * texture * ambient.xyz +
               direct_light(&surface, &near, material.diffuse.xyz * texture, material.specular);
    } else {
        seen = environment_colour(&images, environment_image, environment.xyz,
                                  rays[i].direction_tmax.xyz);
    }
    colour[i].xyz += weight * seen;
}
