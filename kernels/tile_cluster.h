/* tile_cluster.h - a probe at a cluster: which triangles go to which blocks of rays. */
#ifndef RSH_TILE_CLUSTER_H
#define RSH_TILE_CLUSTER_H

#include "tile_work.h"

/* More triangles of a cluster than this are worth asking each ray first. */
#define RSH_MANY_TRIANGLES 4
/* Up to so many blocks look at a cluster's triangles on their own. */
#define RSH_FEW_BLOCKS 3

/* Triangles of a cluster that some ray of the block meets, where that leaves fewer. */
static uint triangles_met_by_rays(rsh_work* work, const rsh_probe* probe, rsh_block* block,
                                  __global const float* cluster, const float* low,
                                  const float* high, uint triangles)
{
    work->node_tests += 16;
    uint rays = rays_meeting(block, probe->ray_sign, low, high);
    if (popcount(rays) + 2 >= popcount(triangles)) return triangles;
    uint met = 0;
    for (; rays; rays &= rays - 1) {
        const rsh_bundle ray = ray_bundle(block, lowest_bit(rays));
        work->node_tests += 16;
        met |= boxes_met(&ray, cluster, 0);
    }
    return triangles & met;
}

/* The triangles of one cluster that were needed so far. */
typedef struct rsh_cluster {
    uint number; /* its group of level 0 */
    uint fetched;
    uint triangle[16];
    rsh_corners corners[16];
} rsh_cluster;

static bool intersect_triangle(rsh_work* work, rsh_cluster* cluster, uint k, uint b)
{
    const rsh_geometry_in* scene = work->scene;
    if (!(cluster->fetched >> k & 1)) {
        cluster->triangle[k] = triangle_in((__global const uint*)scene->boxes, scene->levels,
                                           16 * cluster->number + k);
        fetch_corners(&cluster->corners[k], scene->mesh, scene->vertices, scene->indices,
                      cluster->triangle[k]);
        cluster->fetched |= 1u << k;
    }
    work->ray_tests += 16;
    return intersect_block(block_of(work, b), &cluster->corners[k], cluster->triangle[k],
                           work->is_any);
}

/* Few blocks: each looks for its own triangles. */
static uint intersect_by_block(rsh_work* work, const rsh_probe* probe, rsh_cluster* cluster,
                               uint blocks, uint triangles, const float* low, const float* high)
{
    __global const float* boxes = group_of(work->scene, 0, cluster->number);
    uint changed = 0;
    for (; blocks; blocks &= blocks - 1) {
        const uint b = lowest_bit(blocks);
        rsh_block* block = block_of(work, b);
        const rsh_bundle* bundle =
            is_single(probe->blocks) ? &probe->bundle : block_bundle(work, b);
        work->node_tests += 16;
        uint mine = boxes_met(bundle, boxes, 0) & triangles;
        if (popcount(mine) > RSH_MANY_TRIANGLES && block->is_fit && probe->ray == 16)
            mine = triangles_met_by_rays(work, probe, block, boxes, low, high, mine);
        for (; mine; mine &= mine - 1)
            if (intersect_triangle(work, cluster, lowest_bit(mine), b)) changed |= 1u << b;
    }
    return changed;
}

/* Many blocks: each triangle looks for its own. */
static uint intersect_by_triangle(rsh_work* work, const rsh_probe* probe, rsh_cluster* cluster,
                                  uint blocks, uint triangles)
{
    __global const float* boxes = group_of(work->scene, 0, cluster->number);
    uint changed = 0;
    for (; triangles; triangles &= triangles - 1) {
        const uint k = lowest_bit(triangles);
        float low[3], high[3];
        load_box(boxes, k, low, high);
        work->node_tests += 16;
        uint met = bundles_meeting(&work->blocks, &probe->bundle, low, high) & blocks;
        for (; met; met &= met - 1) {
            const uint b = lowest_bit(met);
            if (intersect_triangle(work, cluster, k, b)) changed |= 1u << b;
        }
    }
    return changed;
}

static void intersect_cluster(rsh_work* work, rsh_probe* probe, uint number, uint blocks,
                              const float* low, const float* high)
{
    rsh_cluster cluster;
    cluster.number = number;
    cluster.fetched = 0;
    uint triangles = boxes_of(work->scene->mesh.triangle_count, number);
    if (popcount(blocks) > RSH_FEW_BLOCKS) {
        work->node_tests += 16;
        triangles &= boxes_met(&probe->bundle, group_of(work->scene, 0, number), 0);
    }
    const uint changed =
        popcount(triangles) < popcount(blocks)
            ? intersect_by_triangle(work, probe, &cluster, blocks, triangles)
            : intersect_by_block(work, probe, &cluster, blocks, triangles, low, high);
    if (changed) update_limits(work, probe, changed);
}

#endif
