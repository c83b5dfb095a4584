/* clear_hits.cl - hits before anything was hit, for engines that improve them step by step.
 *   list_count  in   how many rays of ray_count there are; NULL: all
 *   hits        out  closest
 *   counts      out  of all hits
 */
#include "lanes/stride.h"
#include "rays/levels.h"

__kernel void rsh_clear_hits(__global const rsh_ray* rays, uint ray_count,
                             __global const uint* list_count, __global rsh_hit* hits)
{
    const strided_range mine = my_elements(counted_rays(ray_count, list_count));
    for (uint i = mine.begin; i < mine.end; i += mine.step)
        hits[i] = (rsh_hit){rays[i].direction_tmax.w, 0.0f, 0.0f, RSH_NO_HIT};
}

__kernel void rsh_clear_hit_counts(uint ray_count, __global const uint* list_count,
                                   __global uint* counts)
{
    const strided_range mine = my_elements(counted_rays(ray_count, list_count));
    for (uint i = mine.begin; i < mine.end; i += mine.step) counts[i] = 0;
}
