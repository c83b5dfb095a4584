/* tile_by_ray.h - rays of a block one by one, through the whole scene or what lies in one
 * box. */
#ifndef RSH_TILE_BY_RAY_H
#define RSH_TILE_BY_RAY_H

#include "tile_work.h"

/* Clusters in the order of sort_boxes. Returns whether the ray has a closer hit now. */
static bool intersect_clusters_by_ray(rsh_work* work, rsh_lone_ray* ray, const ulong* sorted,
                                      uint count)
{
    const rsh_scene_in* scene = work->scene;
    bool changed = false;
    while (count && near_of(sorted[--count]) <= ray->limit) {
        const uint number = number_of(sorted[count]);
        work->ray_tests += 16;
        changed |= intersect_cluster(ray, scene->boxes + cluster_at(number),
                                     scene->order + 16ul * number,
                                     scene->scaled[number / 16] >> (number % 16) & 1,
                                     work->is_any);
    }
    return changed;
}

/* Ray k of block b through box `number` of a level; level: their count for the whole scene. */
static void traverse_ray(rsh_work* work, uint b, uint k, uint level, uint number)
{
    rsh_block* block = block_of(work, b);
    rsh_lone_ray ray = lone_ray(block, k);
    const uint bottom = work->stack_size;
    ulong entry = (ulong)level << 28 | number;
    bool changed = level == 1 && intersect_clusters_by_ray(work, &ray, &entry, 1);
    while (level > 1) {
        if (near_of(entry) <= ray.limit) {
            const uint below = level_of(entry) - 1, group = number_of(entry);
            float near[16];
            work->node_tests += 16;
            const uint met = boxes_met_by_ray(&ray, group_of(work, below, group), near) &
                             boxes_of(work, below, group);
            ulong* const top = work->stack + work->stack_size;
            const uint count = sort_boxes(met, near, below, group, top);
            if (below == 1)
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
    for (uint k = 0; k < 16; ++k)
        if (lane_of(&block_of(work, b)->ray[k / RSH_WIDTH].tmax, k % RSH_WIDTH) >= 0.0f)
            traverse_ray(work, b, k, work->scene->levels.count, 0);
}

#endif
