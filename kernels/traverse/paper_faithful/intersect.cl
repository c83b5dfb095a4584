/* intersect.cl - the traversal's last step: intersects the (triangle, ray) pairs that survived.
 *   pairs, pair_count  in      level 0 of the stream
 *   skip               in      a triangle per ray that it does not hit; NULL: none
 *   hits               in/out  closest: .primitive is the best triangle so far, RSH_NO_HIT at
 *                      first
 *   occlusion          in/out  any: a bit per ray
 * With RSH_ALL_HITS, hits and occlusion are what traverse/hit_list.h says.
 */
#include "lanes/stride.h"
#include "traverse/paper_faithful/closest_hit_atomic.h"

RSH_FILLS_VECTORS
__kernel void rsh_intersect(mesh_view mesh, __global const float* vertices,
                            __global const uint* indices, __global const rsh_ray* rays,
                            __global const uint* skip, __global const stream_pair* pairs,
                            __global const uint* pair_count, __global rsh_hit* hits,
                            __global uint* occlusion,
                            uint occlusion_bit RSH_FILTER_PARAMETERS RSH_BATCH_PARAMETERS)
{
    hit_list list = hit_list_in(hits, occlusion_bit, 1);
    const hit_target target = {
        {mesh, vertices, indices, rays, skip RSH_GIVEN_FILTER RSH_GIVEN_BATCH},
        hits,
        occlusion,
        occlusion_bit,
        &list};
    const uint count = *pair_count;
    const strided_range mine = my_elements(count / RSH_WIDTH + (count % RSH_WIDTH != 0));
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        const uint first = i * RSH_WIDTH;
        const uint filled = min((uint)RSH_WIDTH, count - first);
        stream_pair group[RSH_WIDTH];
        for (uint k = 0; k < filled; ++k) group[k] = pairs[first + k];
        intersect_pairs(&target, group, filled);
    }
}
