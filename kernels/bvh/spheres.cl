/* spheres.cl - a sphere around every triangle, or around those that move.
 *   vertices, indices  in      triangles
 *   bounds             in/out  a head, then spheres: centre, radius; radius -1: never hit
 *   wrong              out     RSH_WRONG_BOUNDS: there are no spheres around those that stand still
 * Any centre would do: the radius is measured from the stored one. Does not look at rays.
 */
#include "bvh/spheres.h"
#include "mesh/algebra.h"

/* Centre of the smallest sphere: the middle of the longest edge unless all angles are acute. */
static float3 sphere_centre(triangle_points p)
{
    const float size = fmax(largest3(fabs(p.v1 - p.v0)), largest3(fabs(p.v2 - p.v0)));
    const float scale = scale_to_one(size);
    const float3 ab = scale * (p.v1 - p.v0), ac = scale * (p.v2 - p.v0),
                 bc = scale * (p.v2 - p.v1);
    if (dot(ab, ac) <= 0.0f) return 0.5f * p.v1 + 0.5f * p.v2;
    if (dot(-ab, bc) <= 0.0f) return 0.5f * p.v0 + 0.5f * p.v2;
    if (dot(ac, bc) <= 0.0f) return 0.5f * p.v0 + 0.5f * p.v1;
    const float3 normal = cross(ab, ac);
    const float3 towards = dot(ac, ac) * cross(normal, ab) + dot(ab, ab) * cross(ac, normal);
    const float3 to_centre = towards / (2.0f * dot(normal, normal));
    /* Slivers: the circumcentre is noise, or not finite. */
    if (!(safe_length(to_centre) <= safe_length(ab) + safe_length(ac)))
        return 0.5f * p.v0 + 0.5f * p.v1;
    return p.v0 + to_centre / scale;
}

/* Relative error of a length: u for the subtraction, below 2^-20 for safe_length; 2^-124 covers
 * differences that a device flushes to zero. */
static float triangle_radius(triangle_points p, float3 centre)
{
    const float radius = fmax(safe_length(p.v0 - centre),
                              fmax(safe_length(p.v1 - centre), safe_length(p.v2 - centre)));
    return radius * (1.0f + 0x1p-18f) + 0x1p-124f;
}

/* first: of the triangles that move; 0: all get a sphere. */
__kernel void rsh_spheres(mesh_view mesh, __global const float* vertices,
                          __global const uint* indices, uint first, __global float4* bounds,
                          volatile __global uint* wrong)
{
    const uint i = first + get_global_id(0);
    __global float4* spheres = bounds + RSH_SPHERES_AT;
    if (i == 0) write_spheres_head(mesh.triangle_count, bounds);
    if (first > 0 && !spheres_are_of(mesh.triangle_count, bounds)) {
        if (i == first) atomic_or(wrong, RSH_WRONG_BOUNDS);
        return;
    }
    if (i >= mesh.triangle_count) return; /* launch is rounded up to whole groups */
    triangle_points p;
    if (!load_triangle(mesh, vertices, indices, i, &p) || !is_finite3(p.v0) ||
        !is_finite3(p.v1) || !is_finite3(p.v2)) {
        spheres[i] = (float4)(0.0f, 0.0f, 0.0f, -1.0f);
        return;
    }
    const float3 centre = sphere_centre(p);
    const float radius = triangle_radius(p, centre);
    /* Differences that overflow: a sphere that holds everything. */
    spheres[i] =
        isfinite(radius) ? (float4)(centre, radius) : (float4)(0.0f, 0.0f, 0.0f, INFINITY);
}
