/* find_surfaces.cl - what each ray hits, see rsh_find_surfaces.
 *   rays, hits  in
 *   list_count  in   how many of them there are; NULL: ray_count
 *   surfaces    out  one per ray
 */
#include "lanes/stride.h"
#include "rays/levels.h"
#include "shade/material.h"

/* The words of an rsh_surface, in rows of four floats. */
#define RSH_SURFACE_ROWS (sizeof(rsh_surface) / sizeof(float4))

/* The texture coordinates of the lanes in `bits`; of the others 0. */
static void coordinates_of_lanes(const surface_buffers* buffers,
                                 __global const float* texcoords, const ray_lanes* block,
                                 uint bits, floatv* uv)
{
    float row[2][RSH_WIDTH], u[RSH_WIDTH], v[RSH_WIDTH];
    store_lanes(block->u, u);
    store_lanes(block->v, v);
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        float2 at = (float2)(0.0f);
        const rsh_hit hit = {0.0f, u[k], v[k], block->primitive[k]};
        if (texcoords && bits >> k & 1) at = texture_coordinates(buffers, texcoords, hit);
        row[0][k] = at.x;
        row[1][k] = at.y;
    }
    uv[0] = load_lanes(row[0]);
    uv[1] = load_lanes(row[1]);
}

static void put_vector(float3v v, floatv w, intv is_found, floatv* row)
{
    const floatv zero = (floatv)(0.0f);
    row[0] = select(zero, v.x, is_found);
    row[1] = select(zero, v.y, is_found);
    row[2] = select(zero, v.z, is_found);
    row[3] = select(zero, w, is_found);
}

static void store_surfaces(const ray_lanes* block, const surface_lanes* surface,
                           float3v texture, const floatv* uv, uint found, const uint* index,
                           __global rsh_surface* surfaces)
{
    const intv is_found = mask_of_bits(found);
    const floatv zero = (floatv)(0.0f), one = (floatv)(1.0f);
    floatv row[RSH_SURFACE_ROWS][4];
    put_vector(surface->point, block->t, is_found, row[0]);
    put_vector(surface->geometric, select(-one, one, surface->is_outside), is_found, row[1]);
    put_vector(surface->normal, zero, is_found, row[2]);
    put_vector(texture, zero, is_found, row[3]);
    row[4][0] = uv[0];
    row[4][1] = uv[1];
    row[4][2] = as_floatv(select((uintv)(0u), load_lanes(surface->material), is_found));
    row[4][3] = as_floatv(select((uintv)(RSH_NO_HIT), load_lanes(block->primitive), is_found));
    for (uint r = 0; r < RSH_SURFACE_ROWS; ++r)
        store_rows4(row[r], lanes_with_ray(index), (__global float*)surfaces + 4 * r,
                    4 * RSH_SURFACE_ROWS, index);
}

RSH_FILLS_VECTORS
__kernel void rsh_find_surfaces(mesh_view mesh, __global const float* vertices,
                                __global const uint* indices, __global const float* normals,
                                __global const float* texcoords,
                                __global const uint* material_ids,
                                __global const rsh_material* materials, uint material_count,
                                __global const rsh_texture* textures, uint texture_count,
                                __global const uint* texels, uint ray_count,
                                __global const uint* list_count, __global const rsh_ray* rays,
                                __global const rsh_hit* hits, __global rsh_surface* surfaces)
{
    const surface_buffers buffers = {mesh,    vertices,     indices,
                                     normals, material_ids, material_count};
    const image_list images = {textures, texture_count, texels};
    const strided_range mine = my_blocks(counted_rays(ray_count, list_count));
    for (uint i = mine.begin; i < mine.end; i += RSH_WIDTH * mine.step) {
        uint index[RSH_WIDTH], found;
        ray_lanes block;
        surface_lanes surface;
        floatv uv[2];
        number_lanes(i, mine.end, index);
        load_rays(index, rays, hits, &block);
        found = find_surfaces(&buffers, &block, RSH_LANE_BITS(block.is_active), &surface);
        const float3v texture =
            texture_colours(&buffers, &images, texcoords, materials, &block, &surface, found);
        coordinates_of_lanes(&buffers, texcoords, &block, found, uv);
        store_surfaces(&block, &surface, texture, uv, found, index, surfaces);
    }
}
