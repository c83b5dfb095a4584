/* cut.cl - adds to the colour of each ray what those of its branches are taken to see that will not be
 * traced: reflected, then refracted. See rsh_scene, cut.
 *   rays, hits, weights  in      a wave; weights NULL: all 1
 *   colour               in/out  rgb grows
 * A branch is not traced if it weighs no more than min_weight; after the last bounce that is infinite.
 */
#include "lanes/stride.h"
#include "shade/branch.h"
#include "shade/environment.h"

/* What such branches see. */
typedef struct cut_light {
    image_list images;
    uint image;    /* of the environment */
    bool is_plain; /* the same in all directions: no image */
    float3 colour;
} cut_light;

static float3 cut_colour(const cut_light* light, const surface_buffers* buffers,
                         __global const rsh_material* materials, const branching_hit* at,
                         const departure* from, uint triangle, uint kind)
{
    if (light->is_plain) return light->colour;
    const rsh_ray ray = branch_ray(buffers, materials, at, from, triangle, kind, true);
    return environment_colour(&light->images, light->image, light->colour,
                              ray.direction_tmax.xyz);
}

__kernel void rsh_cut(mesh_view mesh, __global const float* vertices,
                      __global const uint* indices, __global const float* normals,
                      __global const uint* material_ids, __global const rsh_material* materials,
                      uint material_count, __global const rsh_texture* textures,
                      uint texture_count, __global const uint* texels, uint environment_image,
                      float4 colour_of_cut, uint is_plain, uint kinds, float min_weight,
                      uint ray_count, __global const rsh_ray* rays,
                      __global const rsh_hit* hits, __global const float4* weights,
                      __global float4* colour)
{
    const surface_buffers buffers = {mesh,    vertices,     indices,
                                     normals, material_ids, material_count};
    const cut_light light = {
        {textures, texture_count, texels}, environment_image, is_plain != 0, colour_of_cut.xyz};
    const strided_range mine = my_elements(ray_count);
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        branching_hit at;
        const float3 seen = weights ? weights[i].xyz : (float3)(1.0f);
        if (!find_branches(&buffers, materials, kinds, seen, 0.0f, rays[i], hits[i], &at))
            continue;
        const departure from = departure_of(&at.surface, rays[i], hits[i]);
        float3 sum = (float3)(0.0f);
        for (uint kind = 0; kind < RSH_BRANCHES; ++kind)
            if (has_branch(&at, kind) && !(largest3(at.weight[kind]) > min_weight))
                sum += at.weight[kind] * cut_colour(&light, &buffers, materials, &at, &from,
                                                    hits[i].primitive, kind);
        colour[i].xyz += sum;
    }
}
