/* resolve.cl - completes the hits of a traversal: t, u and v of each ray's best triangle.
 *   list_count  in      how many rays of ray_count there are; NULL: all
 *   hits        in/out  in: .primitive only
 */
#include "lanes/stride.h"
#include "mesh/intersect.h"
#include "rays/levels.h"

static rsh_hit resolved(mesh_view mesh, __global const float* vertices,
                        __global const uint* indices, rsh_ray ray, uint primitive)
{
    rsh_hit hit = {ray.direction_tmax.w, 0.0f, 0.0f, primitive};
    if (primitive == RSH_NO_HIT) return hit;
    triangle_points corners;
    load_triangle(mesh, vertices, indices, primitive, &corners);
    intersect_one(ray, corners, &hit);
    return hit;
}

__kernel void rsh_resolve(mesh_view mesh, __global const float* vertices,
                          __global const uint* indices, __global const rsh_ray* rays,
                          uint ray_count, __global const uint* list_count,
                          __global rsh_hit* hits)
{
    const strided_range mine = my_elements(counted_rays(ray_count, list_count));
    for (uint i = mine.begin; i < mine.end; i += mine.step)
        hits[i] = resolved(mesh, vertices, indices, rays[i], hits[i].primitive);
}
