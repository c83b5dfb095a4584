/* shade.cl - what each ray sees, added to its colour, see rsh_shade.
 *   list_count           in      how many rays of ray_count there are; NULL: all
 *   rays, hits, weights  in      weights NULL: all 1
 *   occlusion            in      bit k: light k is hidden; NULL: nothing is hidden
 *   shadow_lights        in      bit k: light k is added after what nothing hides, as by
 *                                shade/shade_lit.cl
 *   colour               in/out  rgb grows, a stays; is_first: rgb only goes out
 * Mirrored and refracted light is added by shading the rays that shade/spawn.cl makes.
 */
#include "lanes/stride.h"
#include "rays/levels.h"
#include "shade/seen.h"

static uintv hidden_lights(__global const uint* occlusion, const uint* index, uint bits)
{
    uint hidden[RSH_WIDTH];
    for (uint k = 0; k < RSH_WIDTH; ++k)
        hidden[k] = occlusion && bits >> k & 1 ? occlusion[index[k]] : 0;
    return load_lanes(hidden);
}

static void add_lights(const seen_block* block, const look_buffers* look, uint shadow_lights,
                       uintv hidden, float3v weight, colour_lanes* sums)
{
    for (uint k = 0; k < look->light_count; ++k) {
        if (!(shadow_lights >> k & 1)) continue;
        const uint bits = block->found & open_lanes(hidden, k);
        const seen_light seen = see_light(block, look->lights[k], bits);
        add_seen(product_v(weight, seen.colour), seen.bits, sums);
    }
}

RSH_FILLS_VECTORS
__kernel void rsh_shade(mesh_view mesh, __global const float* vertices,
                        __global const uint* indices, __global const float* normals,
                        __global const float* texcoords, __global const uint* material_ids,
                        __global const rsh_material* materials, uint material_count,
                        __global const rsh_light* lights, uint light_count,
                        __global const rsh_texture* textures, uint texture_count,
                        __global const uint* texels, float4 ambient, float4 environment,
                        uint environment_image, uint ray_count, __global const uint* list_count,
                        __global const rsh_ray* rays, __global const rsh_hit* hits,
                        __global const float4* weights, __global const uint* occlusion,
                        uint shadow_lights, uint is_first, __global float4* colour)
{
    const surface_buffers buffers = {mesh,    vertices,     indices,
                                     normals, material_ids, material_count};
    const look_buffers look = {texcoords,
                               materials,
                               lights,
                               light_count,
                               {textures, texture_count, texels},
                               ambient.xyz,
                               environment.xyz,
                               environment_image,
                               mesh.features};
    const strided_range mine = my_blocks(counted_rays(ray_count, list_count));
    for (uint i = mine.begin; i < mine.end; i += RSH_WIDTH * mine.step) {
        uint index[RSH_WIDTH];
        seen_block block;
        number_lanes(i, mine.end, index);
        find_seen(&buffers, &look, index, rays, hits, &block);
        const float3v weight = load_weights(index, weights);
        const uintv hidden = hidden_lights(occlusion, index, block.found);
        const float3v seen = see_all_but(&block, &look, shadow_lights, hidden);
        colour_lanes sums = load_sums(index, is_first, colour);
        add_seen(product_v(weight, seen), block.active, &sums);
        if (block.found) add_lights(&block, &look, shadow_lights, hidden, weight, &sums);
        store_sums(&sums, index, colour);
    }
}
