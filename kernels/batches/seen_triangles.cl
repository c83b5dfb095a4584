/* seen_triangles.cl - keeps what shading needs of a scene that comes in batches: the triangle that each ray
 * hits, place i for ray i, as a mesh of its own.
 *   hits          in/out  closest so far, by numbers of the scene; rsh_number_seen: by places from then on
 *   list_count    in      how many rays of ray_count there are; NULL: all
 *   seen_corners, seen_normals, seen_texcoords, seen_material_ids  out  laid out as in a mesh without
 *                         indices; NULL: not wanted
 *   seen_numbers  out     of the triangles, in the scene
 */
#include "lanes/stride.h"
#include "mesh/triangles.h"
#include "rays/levels.h"

/* Floats of a triangle's vertices, so many each. */
static void copy_floats(__global const float* from, const uint* vertex, uint floats,
                        __global float* to)
{
    for (uint c = 0; c < 3; ++c)
        for (uint f = 0; f < floats; ++f)
            to[floats * c + f] = from[(ulong)floats * vertex[c] + f];
}

/* Of the rays that hit a triangle of this batch. */
__kernel void rsh_keep_seen(mesh_view batch, uint first_triangle,
                            __global const float* positions, __global const uint* indices,
                            __global const float* normals, __global const float* texcoords,
                            __global const uint* material_ids, uint ray_count,
                            __global const uint* list_count, __global const rsh_hit* hits,
                            __global float* seen_corners, __global float* seen_normals,
                            __global float* seen_texcoords, __global uint* seen_material_ids)
{
    const strided_range mine = my_elements(counted_rays(ray_count, list_count));
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        const uint triangle = hits[i].primitive - first_triangle;
        uint vertex[3];
        if (triangle >= batch.triangle_count ||
            !triangle_vertices(batch, indices, triangle, vertex))
            continue;
        copy_floats(positions, vertex, 3, seen_corners + 9ul * i);
        if (seen_normals) copy_floats(normals, vertex, 3, seen_normals + 9ul * i);
        if (seen_texcoords) copy_floats(texcoords, vertex, 2, seen_texcoords + 6ul * i);
        if (seen_material_ids) seen_material_ids[i] = material_ids[triangle];
    }
}

__kernel void rsh_number_seen(uint ray_count, __global const uint* list_count,
                              __global rsh_hit* hits, __global uint* seen_numbers)
{
    const strided_range mine = my_elements(counted_rays(ray_count, list_count));
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        seen_numbers[i] = hits[i].primitive;
        if (hits[i].primitive != RSH_NO_HIT) hits[i].primitive = i;
    }
}
