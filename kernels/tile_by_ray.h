/* tile_by_ray.h - rays of a block one by one, through the whole scene or what lies in one
 * box. Their entries on the stack name what is below a box. */
#ifndef RSH_TILE_BY_RAY_H
#define RSH_TILE_BY_RAY_H

#include "tile_work.h"

/* Clusters in the order of sort_boxes. Returns whether the ray has a closer hit now. */
static bool intersect_clusters_by_ray(rsh_work* work, rsh_lone_ray* ray, const ulong* sorted,
                                      uint count)
{
    bool changed = false;
    while (count && near_of(sorted[--count]) <= ray->limit) {
        const uint below = name_of(sorted[count]);
        work->ray_tests += 16;
        changed |= intersect_cluster(ray, cluster_of(work, below), (below & RSH_SCALED) != 0,
                                     work->is_any);
    }
    return changed;
}

/* Ray k of block b through what is below a box of a level. */
static void traverse_ray(rsh_work* work, uint b, uint k, uint level, uint below)
{
    rsh_block* block = block_of(work, b);
    rsh_lone_ray ray = lone_ray(block, k);
    const uint bottom = work->stack_size;
    ulong entry = (ulong)level << 28 | below;
    bool changed = level == 1 && intersect_clusters_by_ray(work, &ray, &entry, 1);
    while (level > 1) {
        if (near_of(entry) <= ray.limit) {
            const uint lower = level_of(entry) - 1;
            __global const float* group = group_of(work, name_of(entry));
            float near[16];
            work->node_tests += 16;
            const uint met = boxes_met_by_ray(&ray, group, near);
            ulong* const top = work->stack + work->stack_size;
            const uint count = sort_boxes(met, near, lower, 0,
                                          (__global const uint*)group + RSH_BELOW_AT, top);
            if (lower == 1)
                changed |= intersect_clusters_by_ray(work, &ray, top, count);
            else
                work->stack_size += count;
        }
        if (work->stack_size == bottom) break;
        entry = work->stack[--work->stack_size];
    }
    if (changed) put_back(&ray, block, k);
}

/* All rays of block b through the whole scene. */
static void traverse_rays(rsh_work* work, uint b)
{
    const rsh_scene_top top = work->scene->top;
    for (uint k = 0; k < 16; ++k)
        if (lane_of(&block_of(work, b)->ray[k / RSH_WIDTH].tmax, k % RSH_WIDTH) >= 0.0f)
            traverse_ray(work, b, k, top.level + 1, top.group);
}

#endif
