/* describe_hits.cl - what else a caller wants to know of hits: their normals and meshes.
 *   ranges, range_count  in   the meshes; range_count 0: one, with id 0
 *   list_count           in   how many rays of ray_count there are; NULL: all
 *   hit_offsets          in   all: where each ray's hits begin, the last: how many there are; NULL:
 *                        closest, one per ray
 *   most                 all: hits that there is room for: if there are more, there are none
 *   hits                 in
 *   normals              out  three floats per hit, 0 of a miss; NULL: nobody wants them
 *   geometry_ids         out  one per hit, RSH_NO_HIT of a miss; NULL: likewise
 */
#define RSH_MESH_RANGES
#include "lanes/stride.h"
#include "mesh/mesh_ranges.h"
#include "mesh/plane.h"
#include "rays/levels.h"

/* Unit, (v1 - v0) x (v2 - v0) by direction. */
static float3 normal_of(mesh_view mesh, __global const float* vertices,
                        __global const uint* indices, uint triangle)
{
    triangle_points p;
    if (!load_triangle(mesh, vertices, indices, triangle, &p)) return (float3)(0.0f);
    return unit3(plane_of(p).normal.high);
}

static uint hits_of(uint ray_count, __global const uint* list_count,
                    __global const ulong* hit_offsets, uint most)
{
    if (!hit_offsets) return counted_rays(ray_count, list_count);
    const ulong total = hit_offsets[ray_count];
    return total > most ? 0 : (uint)total;
}

__kernel void rsh_describe_hits(mesh_view mesh, __global const float* vertices,
                                __global const uint* indices,
                                __global const rsh_mesh_range* ranges, uint range_count,
                                uint ray_count, __global const uint* list_count,
                                __global const ulong* hit_offsets, uint most,
                                __global const rsh_hit* hits, __global float* normals,
                                __global uint* geometry_ids)
{
    const strided_range mine = my_elements(hits_of(ray_count, list_count, hit_offsets, most));
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        const uint triangle = hits[i].primitive;
        const bool is_hit = triangle < mesh.triangle_count;
        float3 normal = (float3)(0.0f);
        if (normals && is_hit) normal = normal_of(mesh, vertices, indices, triangle);
        if (normals) vstore3(normal, i, normals);
        uint id = is_hit ? 0 : RSH_NO_HIT;
        if (geometry_ids && is_hit && range_count)
            id = ranges[range_of(ranges, range_count, triangle)].id;
        if (geometry_ids) geometry_ids[i] = id;
    }
}
