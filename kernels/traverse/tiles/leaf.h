/* leaf.h - the triangles of a cluster against rays: of one block, or of many. */
#ifndef RSH_TRAVERSE_TILES_LEAF_H
#define RSH_TRAVERSE_TILES_LEAF_H

#include "traverse/tiles/state.h"

/* Up to so many triangles of a cluster are tested without asking which rays meet it. */
#define RSH_FEW_TRIANGLES 2

typedef struct rsh_cluster_in {
    __global const float* corners; /* see rsh_cluster */
    __global const uint* triangles;
    bool is_scaled;
    rsh_boxes boxes; /* of the triangles */
} rsh_cluster_in;

/* Boxes are padded as rays/box_node.h says for the largest of the triangles. */
static void load_cluster(const rsh_work* work, const rsh_box* box, rsh_cluster_in* cluster)
{
    cluster->corners = cluster_of(work, box->below);
    cluster->triangles = (__global const uint*)cluster->corners + RSH_TRIANGLES_AT;
    cluster->is_scaled = (box->below & RSH_SCALED) != 0;
    float reach = 0.0f;
    for (uint axis = 0; axis < 3; ++axis)
        reach = fmax(reach, fmax(fabs(box->low[axis]), fabs(box->high[axis])));
    const floatv pad = (floatv)(pad_of(reach));
    for (uint axis = 0; axis < 3; ++axis)
        for (uint v = 0; v < RSH_VECTORS; ++v) {
            __global const float* row = cluster->corners + 16 * axis + RSH_WIDTH * v;
            const floatv a = load_lanes(row), b = load_lanes(row + 48),
                         c = load_lanes(row + 96);
            cluster->boxes.low[axis][v] = lesser(a, lesser(b, c)) - pad;
            cluster->boxes.high[axis][v] = greater(a, greater(b, c)) + pad;
        }
}

static void intersect_triangle(rsh_work* work, const rsh_cluster_in* cluster, uint k, uint b)
{
    rsh_corners corners;
    corners.scale = 1.0f;
    for (uint i = 0; i < 9; ++i) corners.at[i] = cluster->corners[16 * i + k];
    if (cluster->is_scaled) corners.scale = scale_of(corners.at);
    work->ray_tests += 16;
    if (intersect_block(block_of(work, b), &corners, cluster->triangles[k], work->is_any))
        lower_block_limit(work, b);
}

static void intersect_by_rays(rsh_work* work, const rsh_cluster_in* cluster, uint b, uint rays)
{
    rsh_block* block = block_of(work, b);
    bool changed = false;
    for (; rays; rays &= rays - 1) {
        const uint k = lowest_bit(rays);
        rsh_lone_ray ray = lone_ray(block, k);
        work->ray_tests += 16;
        if (!intersect_cluster(&ray, cluster->corners, cluster->is_scaled, work->is_any))
            continue;
        put_back(&ray, block, k);
        changed = true;
    }
    if (changed) lower_block_limit(work, b);
}

/* Triangle by triangle, or each of the rays that meet the cluster on its own, whatever are
 * fewer. rays: 0 if not known yet. */
static void intersect_loaded_cluster(rsh_work* work, const rsh_cluster_in* cluster, uint b,
                                     const int* sign, const rsh_box* box, uint rays)
{
    rsh_block* block = block_of(work, b);
    work->node_tests += 16;
    uint triangles = boxes_met(block_bundle(work, b), &cluster->boxes, 0);
    const uint count = popcount(triangles);
    if (count > RSH_FEW_TRIANGLES && block->is_fit) {
        if (!rays) {
            work->node_tests += 16;
            rays = rays_meeting(block, sign, box->low, box->high);
        }
        if (popcount(rays) < count) {
            intersect_by_rays(work, cluster, b, rays);
            return;
        }
    }
    for (; triangles; triangles &= triangles - 1)
        intersect_triangle(work, cluster, lowest_bit(triangles), b);
}

static void intersect_cluster_by_block(rsh_work* work, uint b, const int* sign,
                                       const rsh_box* box, uint rays)
{
    rsh_cluster_in cluster;
    load_cluster(work, box, &cluster);
    intersect_loaded_cluster(work, &cluster, b, sign, box, rays);
}

/* Many blocks: each for itself, or each triangle looks for its own. */
static void intersect_cluster_by_blocks(rsh_work* work, const rsh_bundle* common,
                                        const int* sign, const rsh_box* box, uint blocks)
{
    rsh_cluster_in cluster;
    load_cluster(work, box, &cluster);
    work->node_tests += 16;
    uint triangles = boxes_met(common, &cluster.boxes, 0);
    if (popcount(triangles) >= popcount(blocks)) {
        for (; blocks; blocks &= blocks - 1)
            intersect_loaded_cluster(work, &cluster, lowest_bit(blocks), sign, box, 0);
        return;
    }
    for (; triangles; triangles &= triangles - 1) {
        const uint k = lowest_bit(triangles);
        float low[3], high[3];
        for (uint axis = 0; axis < 3; ++axis) {
            low[axis] = lane_of(cluster.boxes.low[axis], k);
            high[axis] = lane_of(cluster.boxes.high[axis], k);
        }
        work->node_tests += 16;
        uint met = bundles_meeting(&work->blocks, common, low, high) & blocks;
        for (; met; met &= met - 1) intersect_triangle(work, &cluster, k, lowest_bit(met));
    }
}

#endif
