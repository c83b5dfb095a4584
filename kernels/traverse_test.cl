/* traverse_test.cl - one level of the traversal: tests each pair against the node's four children.
 *   pairs, pair_count     in   survivors of the level above; at the root none are stored, there
 *                              every triangle of the batch is one
 *   candidates            out  4 per pair: (triangle, child) or NULL
 *   candidate_count       out  how many, NULLs included
 * At most `limit` pairs are tested: traverse_walk.cl finishes the others. Packing the survivors is
 * the reduction's job. A work-item tests RSH_PAIRS pairs at once: their quads fill a vector.
 */
#include "cone_sphere.h"
#include "levels.h"
#include "stride.h"

#if RSH_WIDTH == 16
#define RSH_PAIRS 4
RSH_DEFINE_CONE_SPHERE(quads_meet, float16, int16)
#define RSH_GATHER(member) ((float16)(q[0]->member, q[1]->member, q[2]->member, q[3]->member))
#define RSH_SPREAD(c) ((float16)((float4)(s[0].c), (float4)(s[1].c), (float4)(s[2].c), (float4)(s[3].c)))
#elif RSH_WIDTH == 8
#define RSH_PAIRS 2
RSH_DEFINE_CONE_SPHERE(quads_meet, float8, int8)
#define RSH_GATHER(member) ((float8)(q[0]->member, q[1]->member))
#define RSH_SPREAD(c) ((float8)((float4)(s[0].c), (float4)(s[1].c)))
#else
#define RSH_PAIRS 1
RSH_DEFINE_CONE_SPHERE(quads_meet, float4, int4)
#define RSH_GATHER(member) (q[0]->member)
#define RSH_SPREAD(c) ((float4)(s[0].c))
#endif

/* Lanes 4 i .. 4 i + 3 tell which children of pair i survive: -1, else 0. */
static void test_pairs(const rsh_levels* levels, uint level, const rsh_pair* pairs,
                       __global const float4* spheres, __global const rsh_node_quad* quads,
                       int* survives)
{
    __global const rsh_node_quad* q[RSH_PAIRS];
    float4 s[RSH_PAIRS];
    for (uint i = 0; i < RSH_PAIRS; ++i) {
        q[i] = quads + quad_index(levels, level, pairs[i].node);
        s[i] = spheres[pairs[i].triangle];
    }
    const quads_meet_lanes lanes = {
        RSH_GATHER(apex_x), RSH_GATHER(apex_y), RSH_GATHER(apex_z), RSH_GATHER(radius),
        RSH_GATHER(axis_x), RSH_GATHER(axis_y), RSH_GATHER(axis_z), RSH_GATHER(sine),
        RSH_SPREAD(x),      RSH_SPREAD(y),      RSH_SPREAD(z),      RSH_SPREAD(w)};
#if RSH_PAIRS == 4
    vstore16(quads_meet(&lanes), 0, survives);
#elif RSH_PAIRS == 2
    vstore8(quads_meet(&lanes), 0, survives);
#else
    vstore4(quads_meet(&lanes), 0, survives);
#endif
}

static void write_children(const rsh_levels* levels, uint level, rsh_pair pair, const int* survives,
                           ulong at, __global uint* candidates)
{
    const uint4 triangle = select((uint4)(RSH_NO_HIT), (uint4)(pair.triangle),
                                  as_uint4(vload4(0, survives)));
    const uint4 node = child_names(levels, level, pair.node);
    vstore8((uint8)(triangle.x, node.x, triangle.y, node.y, triangle.z, node.z, triangle.w, node.w),
            at, candidates);
}

/* Pairs first .. first + count - 1, at most RSH_PAIRS of them; the last one fills up the vector. */
static void test_group(const rsh_levels* levels, uint level, const rsh_pair* pairs, uint first,
                       uint count, __global const float4* spheres,
                       __global const rsh_node_quad* quads, __global uint* candidates)
{
    int survives[4 * RSH_PAIRS];
    test_pairs(levels, level, pairs, spheres, quads, survives);
    for (uint i = 0; i < count; ++i)
        write_children(levels, level, pairs[i], survives + 4 * i, first + i, candidates);
}

static uint group_count(uint count) { return count / RSH_PAIRS + (count % RSH_PAIRS != 0); }

__kernel void rsh_traverse_test(rsh_levels levels, uint level, uint limit,
                                __global const float4* spheres,
                                __global const rsh_node_quad* quads,
                                __global const rsh_pair* pairs, __global const uint* pair_count,
                                __global uint* candidates, __global uint* candidate_count)
{
    const uint count = min(pair_count[level + 1], limit);
    if (get_global_id(0) == 0) *candidate_count = 4 * count;
    const rsh_stride mine = my_elements(group_count(count));
    for (uint g = mine.begin; g < mine.end; g += mine.step) {
        const uint first = g * RSH_PAIRS;
        rsh_pair group[RSH_PAIRS];
        for (uint i = 0; i < RSH_PAIRS; ++i) group[i] = pairs[min(first + i, count - 1)];
        test_group(&levels, level, group, first, min((uint)RSH_PAIRS, count - first), spheres,
                   quads, candidates);
    }
}

/* The same at the root: pair i is (first + i, root). */
__kernel void rsh_traverse_test_root(rsh_levels levels, uint level, uint first_triangle, uint count,
                                     __global const float4* spheres,
                                     __global const rsh_node_quad* quads, __global uint* candidates,
                                     __global uint* candidate_count)
{
    if (get_global_id(0) == 0) *candidate_count = 4 * count;
    const rsh_stride mine = my_elements(group_count(count));
    for (uint g = mine.begin; g < mine.end; g += mine.step) {
        const uint first = g * RSH_PAIRS;
        rsh_pair group[RSH_PAIRS];
        for (uint i = 0; i < RSH_PAIRS; ++i)
            group[i] = (rsh_pair){first_triangle + min(first + i, count - 1), 0};
        test_group(&levels, level, group, first, min((uint)RSH_PAIRS, count - first), spheres,
                   quads, candidates);
    }
}
