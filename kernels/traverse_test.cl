/* traverse_test.cl - one level of the traversal: tests each pair against the node's four children.
 *   pairs, pair_count     in   survivors of the level above; at the root none are stored, there
 *                              every triangle of the batch is one
 *   candidates            out  4 per pair: (triangle, child) or NULL
 *   candidate_count       out  how many, NULLs included
 * At most `limit` pairs are tested: traverse_walk.cl finishes the others. Packing the survivors is
 * the reduction's job.
 */
#include "cone_sphere.h"
#include "levels.h"
#include "stride.h"

static uint8 children_that_meet(const rsh_levels* levels, uint level, rsh_pair pair, float4 sphere,
                                __global const rsh_node_quad* quads)
{
    const rsh_node_quad quad = quads[levels->first_quad[level] + pair.node];
    const int4 keep = may_meet(&quad, sphere) & (int4)(sphere.w >= 0.0f ? -1 : 0);
    const uint4 triangle = select((uint4)(RSH_NO_HIT), (uint4)(pair.triangle), as_uint4(keep));
    uint8 out;
    out.even = triangle;
    out.odd = (uint4)(child_index(levels, level, pair.node, 0), child_index(levels, level, pair.node, 1),
                      child_index(levels, level, pair.node, 2), child_index(levels, level, pair.node, 3));
    return out;
}

__kernel void rsh_traverse_test(rsh_levels levels, uint level, uint limit,
                                __global const float4* spheres,
                                __global const rsh_node_quad* quads,
                                __global const rsh_pair* pairs, __global const uint* pair_count,
                                __global uint* candidates, __global uint* candidate_count)
{
    const uint count = min(pair_count[level + 1], limit);
    if (get_global_id(0) == 0) *candidate_count = 4 * count;
    const rsh_stride mine = my_elements(count);
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        const rsh_pair pair = pairs[i];
        vstore8(children_that_meet(&levels, level, pair, spheres[pair.triangle], quads), i,
                candidates);
    }
}

/* The same at the root: pair i is (first + i, root). */
__kernel void rsh_traverse_test_root(rsh_levels levels, uint level, uint first, uint count,
                                     __global const float4* spheres,
                                     __global const rsh_node_quad* quads, __global uint* candidates,
                                     __global uint* candidate_count)
{
    if (get_global_id(0) == 0) *candidate_count = 4 * count;
    const rsh_stride mine = my_elements(count);
    for (uint i = mine.begin; i < mine.end; i += mine.step) {
        const rsh_pair pair = {first + i, 0};
        vstore8(children_that_meet(&levels, level, pair, spheres[pair.triangle], quads), i,
                candidates);
    }
}
