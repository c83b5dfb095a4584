/* resolve.cl - completes the hits of a traversal: t, u and v of each ray's best triangle.
 *   hits  in/out  in: .primitive only
 */
#include "mesh/intersect.h"

__kernel void rsh_resolve(mesh_view mesh, __global const float* vertices,
                          __global const uint* indices, __global const rsh_ray* rays,
                          uint ray_count, __global rsh_hit* hits)
{
    const uint i = get_global_id(0);
    if (i >= ray_count) return;
    const rsh_ray ray = rays[i];
    rsh_hit hit = {ray.direction_tmax.w, 0.0f, 0.0f, hits[i].primitive};
    if (hit.primitive != RSH_NO_HIT) {
        triangle_points corners;
        load_triangle(mesh, vertices, indices, hit.primitive, &corners);
        intersect_one(ray, corners, &hit);
    }
    hits[i] = hit;
}
