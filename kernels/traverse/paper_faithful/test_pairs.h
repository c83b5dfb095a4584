/* test_pairs.h - cone-sphere tests of RSH_PAIRS pairs at once: their quads fill a vector. */
#ifndef RSH_TRAVERSE_PAPER_FAITHFUL_TEST_PAIRS_H
#define RSH_TRAVERSE_PAPER_FAITHFUL_TEST_PAIRS_H

#include "bvh/spheres.h"
#include "rays/cone_sphere.h"
#include "rays/levels.h"
#include "rays/nodes_head.h"
#include "traverse/paper_faithful/types.h"

#if RSH_WIDTH == 16
#define RSH_PAIRS 4
RSH_DEFINE_CONE_SPHERE(quads_meet, float16, int16)
#define RSH_QUAD_MEMBER(member) \
    ((float16)(q[0]->member, q[1]->member, q[2]->member, q[3]->member))
#define RSH_SPHERE_MEMBER(c) \
    ((float16)((float4)(s[0].c), (float4)(s[1].c), (float4)(s[2].c), (float4)(s[3].c)))
#elif RSH_WIDTH == 8
#define RSH_PAIRS 2
RSH_DEFINE_CONE_SPHERE(quads_meet, float8, int8)
#define RSH_QUAD_MEMBER(member) ((float8)(q[0]->member, q[1]->member))
#define RSH_SPHERE_MEMBER(c) ((float8)((float4)(s[0].c), (float4)(s[1].c)))
#else
#define RSH_PAIRS 1
RSH_DEFINE_CONE_SPHERE(quads_meet, float4, int4)
#define RSH_QUAD_MEMBER(member) (q[0]->member)
#define RSH_SPHERE_MEMBER(c) ((float4)(s[0].c))
#endif

/* Lanes 4 i .. 4 i + 3 tell which children of pair i survive: -1, else 0. */
static void test_pairs(const ray_levels* levels, uint level, const stream_pair* pairs,
                       __global const float4* bounds, __global const uint* nodes, int* survives)
{
    __global const cone_node4* quads =
        (__global const cone_node4*)(nodes + RSH_NODES_HEAD_WORDS);
    __global const cone_node4* q[RSH_PAIRS];
    float4 s[RSH_PAIRS];
    for (uint i = 0; i < RSH_PAIRS; ++i) {
        q[i] = quads + quad_index(levels, level, pairs[i].node);
        s[i] = bounds[RSH_SPHERES_AT + pairs[i].triangle];
    }
    const quads_meet_lanes lanes = {
        RSH_QUAD_MEMBER(apex_x), RSH_QUAD_MEMBER(apex_y), RSH_QUAD_MEMBER(apex_z),
        RSH_QUAD_MEMBER(radius), RSH_QUAD_MEMBER(axis_x), RSH_QUAD_MEMBER(axis_y),
        RSH_QUAD_MEMBER(axis_z), RSH_QUAD_MEMBER(sine),   RSH_SPHERE_MEMBER(x),
        RSH_SPHERE_MEMBER(y),    RSH_SPHERE_MEMBER(z),    RSH_SPHERE_MEMBER(w)};
#if RSH_PAIRS == 4
    vstore16(quads_meet(&lanes), 0, survives);
#elif RSH_PAIRS == 2
    vstore8(quads_meet(&lanes), 0, survives);
#else
    vstore4(quads_meet(&lanes), 0, survives);
#endif
}

#endif
