/* descend_ray.h - rays of a block one by one, through the whole scene or what lies in one
 * box. Their entries on the stack name what is below a box. */
#ifndef RSH_TRAVERSE_TILES_DESCEND_RAY_H
#define RSH_TRAVERSE_TILES_DESCEND_RAY_H

#include "traverse/tiles/state.h"

/* Ray k of block b through what is below a box. */
static void traverse_ray(rsh_work* work, uint b, uint k, uint below)
{
    rsh_block* block = block_of(work, b);
    rsh_lone_ray ray = lone_ray(block, k);
    const uint bottom = work->stack_size;
    work->stack[work->stack_size++] = below;
    bool changed = false;
    while (work->stack_size > bottom) {
        const ulong top = work->stack[--work->stack_size];
        if (near_of(top) > ray.limit) continue;
        const uint at = name_of(top);
        if (is_cluster(at)) {
            work->ray_tests += 16;
            changed |= intersect_cluster(&ray, cluster_of(work, at), (at & RSH_SCALED) != 0,
                                         work->is_any);
            continue;
        }
        __global const float* group = group_of(work, at);
        float near[16];
        work->node_tests += 16;
        const uint met = boxes_met_by_ray(&ray, group, near);
        work->stack_size += sort_boxes(met, near, 0, (__global const uint*)group + RSH_BELOW_AT,
                                       work->stack + work->stack_size);
    }
    if (changed) put_back(&ray, block, k);
}

/* All rays of block b through the whole scene. */
static void traverse_rays(rsh_work* work, uint b)
{
    for (uint k = 0; k < 16; ++k)
        if (lane_of(&block_of(work, b)->ray[k / RSH_WIDTH].tmax, k % RSH_WIDTH) >= 0.0f)
            traverse_ray(work, b, k, work->scene->top);
}

#endif
