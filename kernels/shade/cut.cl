/* cut.cl - adds to the colour of each ray what those of its branches are taken to see that will not be
 * traced: reflected, then refracted. See rsh_scene, cut.
 *   list_count           in      how many rays of ray_count there are; NULL: all
 *   rays, hits, weights  in      a wave; weights NULL: all 1
 *   colour               in/out  rgb grows
 * A branch is not traced if it weighs no more than min_weight; after the last bounce that is infinite.
 */
#include "lanes/stride.h"
#include "rays/levels.h"
#include "shade/branch.h"
#include "shade/environment.h"

/* What such branches see. */
typedef struct cut_light {
    image_list images;
    uint image;      /* of the environment */
    uint is_ambient; /* they see the ambient light, and no image */
    uint features;   /* of the scene */
    float3 colour;
} cut_light;

/* What the lanes in `bits` see by their branches of that kind. */
static float3v cut_colours(const cut_light* light, const branch_lanes* at,
                           const departure_lanes* from, uint kind, uint bits)
{
    if (light->is_ambient || !has_environment_image(light->features))
        return lanes_of(light->colour);
    float row[3][RSH_WIDTH], seen[3][RSH_WIDTH];
    store_v(send_branches(at, from, kind, true).direction, row);
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        float3 colour = (float3)(0.0f);
        if (bits >> k & 1)
            colour = environment_colour(&light->images, light->image, light->colour,
                                        (float3)(row[0][k], row[1][k], row[2][k]));
        put_in_lane(colour, k, seen);
    }
    return load_v(seen);
}

static void add_to_colours(float3v sum, const uint* index, uint bits, __global float4* colour)
{
    uint filled[RSH_WIDTH];
    floatv row[4];
    fill_lanes(load_lanes(index), bits, filled);
    load_rows4((__global const float*)colour, 4, filled, row);
    row[0] += sum.x;
    row[1] += sum.y;
    row[2] += sum.z;
    store_rows4(row, bits, (__global float*)colour, 4, index);
}

RSH_FILLS_VECTORS
__kernel void rsh_cut(mesh_view mesh, __global const float* vertices,
                      __global const uint* indices, __global const float* normals,
                      __global const uint* material_ids, __global const rsh_material* materials,
                      uint material_count, __global const rsh_texture* textures,
                      uint texture_count, __global const uint* texels, uint environment_image,
                      float4 colour_of_cut, uint is_ambient, uint kinds, float min_weight,
                      uint ray_count, __global const uint* list_count,
                      __global const rsh_ray* rays, __global const rsh_hit* hits,
                      __global const float4* weights, __global float4* colour)
{
    const surface_buffers buffers = {mesh,    vertices,     indices,
                                     normals, material_ids, material_count};
    const cut_light light = {{textures, texture_count, texels},
                             environment_image,
                             is_ambient,
                             mesh.features,
                             colour_of_cut.xyz};
    const strided_range mine = my_blocks(counted_rays(ray_count, list_count));
    for (uint i = mine.begin; i < mine.end; i += RSH_WIDTH * mine.step) {
        uint index[RSH_WIDTH];
        ray_lanes block;
        branch_lanes at;
        number_lanes(i, mine.end, index);
        load_rays(index, rays, hits, &block);
        const uint bits = candidate_lanes(&buffers, materials, kinds, block.primitive);
        if (bits == 0) continue;
        const uint found = find_branches(&buffers, materials, kinds,
                                         load_weights(index, weights), 0.0f, &block, bits, &at);
        if (found == 0) continue;
        const departure_lanes from = departures_of(&at.surface, &block);
        float3v sum = lanes_of((float3)(0.0f));
        for (uint kind = 0; kind < RSH_BRANCHES; ++kind) {
            const intv is_cut = largest_v(at.weight[kind]) <= (floatv)(min_weight);
            const uint cut = at.bits[kind] & RSH_LANE_BITS(is_cut);
            if (cut == 0) continue;
            const float3v seen = cut_colours(&light, &at, &from, kind, cut);
            sum =
                select_v(sum, sum_v(sum, product_v(at.weight[kind], seen)), mask_of_bits(cut));
        }
        add_to_colours(sum, index, found, colour);
    }
}
