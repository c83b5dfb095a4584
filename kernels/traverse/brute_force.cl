/* brute_force.cl - every ray against every triangle: the yardstick of all engines.
 *   list_count in      how many rays of ray_count there are; NULL: all
 *   skip       in      a triangle per ray that it does not hit; NULL: none
 *   hits       out     closest
 *   occlusion  in/out  any: a bit per ray
 *   tests_per_ray  in/out  grows by the triangles that each ray was tested against; may be NULL
 * With RSH_ALL_HITS, hits and occlusion are what traverse/hit_list.h says.
 */
#include "rays/levels.h"
#include "traverse/brute_force.h"

__kernel void rsh_brute_force(
    mesh_view mesh, __global const float* vertices, __global const uint* indices,
    __global const rsh_ray* rays, __global const uint* skip, uint ray_count,
    __global const uint* list_count, __global rsh_hit* hits, __global uint* occlusion,
    uint occlusion_bit, __global uint* tests_per_ray RSH_FILTER_PARAMETERS RSH_BATCH_PARAMETERS)
{
    const uint first = get_global_id(0) * RSH_RAYS_PER_ITEM;
    const uint count = counted_rays(ray_count, list_count);
    if (first >= count) return;
    uint index[RSH_RAYS_PER_ITEM];
    for (uint i = 0; i < RSH_RAYS_PER_ITEM; ++i)
        index[i] = first + i < count ? first + i : RSH_NO_RAY;
    item_hits found;
    const triangles_left left = {mesh, vertices, indices, rays,
                                 skip RSH_GIVEN_FILTER RSH_GIVEN_BATCH};
    hit_list list = hit_list_in(hits, occlusion_bit, 1);
    trace_by_force(&left, index, &list, &found);
    for (uint i = 0; i < RSH_RAYS_PER_ITEM && first + i < count; ++i) {
#if RSH_ALL_HITS
        occlusion[first + i] = found.count[i];
#else
        if (!occlusion_bit)
            hits[first + i] = hit_at(&found, i, rays[first + i]);
        else if (found.primitive[i] != RSH_NO_HIT)
            occlusion[first + i] |= occlusion_bit;
#endif
        if (tests_per_ray && is_active(rays[first + i]))
            tests_per_ray[first + i] += mesh.triangle_count;
    }
}
