/* merge_hits.cl - one batch of the scene's triangles after the other, for engines that know nothing of other
 * batches: rays end at the hits of these, and what they find is merged.
 *   list_count  in      how many rays of ray_count there are; NULL: all
 *   shortened   out     the rays
 *   found       in      hits of the shortened rays, by numbers of the batch
 *   hits        in/out  of all batches, by numbers of the scene
 */
#include "lanes/stride.h"
#include "rays/levels.h"

__kernel void rsh_shorten_rays(__global const rsh_ray* rays, uint ray_count,
                               __global const uint* list_count, __global const rsh_hit* hits,
                               __global rsh_ray* shortened)
{
    const strided_range mine = my_elements(counted_rays(ray_count, list_count));
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        rsh_ray ray = rays[i];
        const rsh_hit hit = hits[i];
        if (hit.primitive != RSH_NO_HIT && hit.t <= ray.direction_tmax.w)
            ray.direction_tmax.w = hit.t;
        shortened[i] = ray;
    }
}

/* is_continued: 0: `hits` holds nothing yet. */
__kernel void rsh_merge_hits(__global const rsh_hit* found, uint ray_count,
                             __global const uint* list_count, uint first_triangle,
                             uint is_continued, __global rsh_hit* hits)
{
    const strided_range mine = my_elements(counted_rays(ray_count, list_count));
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        rsh_hit hit = found[i];
        if (hit.primitive == RSH_NO_HIT && is_continued) continue;
        if (hit.primitive != RSH_NO_HIT) hit.primitive += first_triangle;
        const rsh_hit before = hits[i];
        if (!is_continued || before.primitive == RSH_NO_HIT || hit.t < before.t ||
            (hit.t == before.t && hit.primitive < before.primitive))
            hits[i] = hit;
    }
}
