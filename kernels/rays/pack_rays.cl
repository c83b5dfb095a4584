/* pack_rays.cl - rays whose parts lie in arrays of their own, or interleaved, as rsh_ray.
 *   list_count           in   how many rays of ray_count there are; NULL: all
 *   origins, directions  in   three floats per ray
 *   tmin, tmax           in   one; NULL: 0, and infinity
 *   rays                 out
 */
#include "lanes/stride.h"
#include "mesh/triangles.h"
#include "rays/levels.h"

/* The floats of a ray. */
static __global const float* floats_of(__global const float* floats, ray_floats_view at,
                                       uint ray)
{
    return floats + word_offset(at.first_low, at.first_high) + (ulong)at.stride * ray;
}

__kernel void rsh_pack_rays(uint ray_count, __global const uint* list_count,
                            __global const float* origins, ray_floats_view origins_at,
                            __global const float* directions, ray_floats_view directions_at,
                            __global const float* tmin, ray_floats_view tmin_at,
                            __global const float* tmax, ray_floats_view tmax_at,
                            __global rsh_ray* rays)
{
    const strided_range mine = my_elements(counted_rays(ray_count, list_count));
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        const float begin = tmin ? *floats_of(tmin, tmin_at, i) : 0.0f;
        const float end = tmax ? *floats_of(tmax, tmax_at, i) : INFINITY;
        const float3 origin = vload3(0, floats_of(origins, origins_at, i));
        const float3 direction = vload3(0, floats_of(directions, directions_at, i));
        rays[i] = (rsh_ray){(float4)(origin, begin), (float4)(direction, end)};
    }
}
