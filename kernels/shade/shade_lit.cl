/* shade_lit.cl - what each ray sees of one light, and the ray that shows whether it is hidden: both
 * from a surface that is found once. What rsh_spawn and rsh_shade do is done in another order, with
 * the same bits.
 *   list_count           in      how many rays of ray_count there are; NULL: all
 *   rays, hits, weights  in      weights NULL: all 1
 *   is_base              in      colour grows by what no shadow falls on, as in shade/shade.cl, and
 *                                occlusion goes out: 0
 *   colour               in/out  rgb grows, a stays; is_first: rgb only goes out
 *   spawned_rays, spawned_skip, active_count  as in shade/spawn_shadow.cl
 *   light_colour         out     what rsh_add_light will add to colour
 */
#include "lanes/stride.h"
#include "rays/levels.h"
#include "shade/seen.h"
#include "shade/shadow_ray.h"

/* One light, and what comes of it. */
typedef struct lit_pass {
    rsh_light source;
    uint shadow_lights, is_base, is_first;
    __global const rsh_ray* rays;
    __global const rsh_hit* hits;
    __global const float4* weights;
    __global uint* occlusion;
    __global float4* colour;
    __global rsh_ray* spawned_rays;
    __global uint* spawned_skip;
    __global float4* light_colour;
} lit_pass;

static void expect_stores(const lit_pass* pass, uint i)
{
    expect_rows((__global const float*)pass->spawned_rays, 8, i);
    expect_rows((__global const float*)pass->spawned_skip, 1, i);
    expect_rows((__global const float*)pass->light_colour, 4, i);
    if (pass->is_base) expect_rows((__global const float*)pass->colour, 4, i);
}

/* What no shadow falls on. */
static void add_base(const seen_block* block, const look_buffers* look, const lit_pass* pass,
                     const uint* index, float3v weight)
{
    for (uint k = 0; k < RSH_WIDTH; ++k)
        if (index[k] != RSH_NO_RAY) pass->occlusion[index[k]] = 0;
    const float3v base = see_all_but(block, look, pass->shadow_lights, (uintv)(0u));
    colour_lanes sums = load_sums(index, pass->is_first, pass->colour);
    add_seen(product_v(weight, base), block->active, &sums);
    store_sums(&sums, index, pass->colour);
}

/* The rays from i to end, RSH_WIDTH at most. Returns how many are sent to the light. */
RSH_CALLED static uint shade_block(const surface_buffers* buffers, const look_buffers* look,
                                   const lit_pass* pass, uint i, uint end)
{
    uint index[RSH_WIDTH];
    seen_block block;
    seen_light seen;
    sent_rays sent;
    number_lanes(i, end, index);
    expect_stores(pass, i);
    find_seen(buffers, look, index, pass->rays, pass->hits, &block);
    const float3v weight = load_weights(index, pass->weights);
    seen.bits = sent.bits = 0;
    if (block.found) seen = see_light(&block, pass->source, block.found);
    if (seen.bits && pass->source.casts_shadow)
        sent = send_to_light(pass->source, &seen.arrival, &block.surface, &block.rays,
                             seen.bits & RSH_LANE_BITS(block.lit.sends_back), true);
    if (pass->is_base) add_base(&block, look, pass, index, weight);
    store_sent_rays(&sent, index, block.rays.primitive, pass->spawned_rays, pass->spawned_skip);
    store_sent_weights(product_v(weight, seen.colour), seen.bits, index, pass->light_colour);
    return popcount(sent.bits);
}

RSH_FILLS_VECTORS
__kernel void rsh_shade_lit(mesh_view mesh, __global const float* vertices,
                            __global const uint* indices, __global const float* normals,
                            __global const float* texcoords, __global const uint* material_ids,
                            __global const rsh_material* materials, uint material_count,
                            __global const rsh_light* lights, uint light_count,
                            __global const rsh_texture* textures, uint texture_count,
                            __global const uint* texels, float4 ambient, float4 environment,
                            uint environment_image, uint ray_count,
                            __global const uint* list_count, __global const rsh_ray* rays,
                            __global const rsh_hit* hits, __global const float4* weights,
                            uint shadow_lights, uint light, uint is_base,
                            __global uint* occlusion, uint is_first, __global float4* colour,
                            __global rsh_ray* spawned_rays, __global uint* spawned_skip,
                            __global float4* light_colour, __global uint* active_count)
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
    const lit_pass pass = {lights[light], shadow_lights, is_base,      is_first,
                           rays,          hits,          weights,      occlusion,
                           colour,        spawned_rays,  spawned_skip, light_colour};
    const strided_range mine = my_blocks(counted_rays(ray_count, list_count));
    uint active = 0;
    for (uint i = mine.begin; i < mine.end; i += RSH_WIDTH * mine.step)
        active += shade_block(&buffers, &look, &pass, i, mine.end);
    add_active(active_count, active);
}

/* Where the light is not hidden, light_colour is added to colour. */
__kernel void rsh_add_light(uint ray_count, __global const uint* list_count, uint light,
                            __global const uint* occlusion, __global const float4* light_colour,
                            __global float4* colour)
{
    const strided_range mine = my_elements(counted_rays(ray_count, list_count));
    for (uint i = mine.begin; i < mine.end; i += mine.step)
        if (!(occlusion[i] >> light & 1)) colour[i].xyz += light_colour[i].xyz;
}
