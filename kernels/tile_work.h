/* tile_work.h - what a work-item knows while it takes a tile through the scene: the scene, the
 * tile's blocks, and the probe that goes down the boxes. */
#ifndef RSH_TILE_WORK_H
#define RSH_TILE_WORK_H

#include "scene_boxes.h"
#include "tile_block.h"

typedef struct rsh_geometry_in {
    rsh_mesh mesh;
    __global const float* vertices;
    __global const uint* indices;
    __global const float* boxes;
    __global const uint* children;
    rsh_box_levels levels;
} rsh_geometry_in;

typedef struct rsh_work {
    const rsh_geometry_in* scene;
    __global const rsh_ray* rays;
    __global const float* nodes; /* of the tile */
    rsh_tile tile;
    bool is_any;
    bool is_converging; /* nodes run backwards: a hit is no limit to them */
    uint loaded;        /* blocks */
    float scene_size;   /* longest side */
    float cluster_size; /* see scene_boxes.h */
    rsh_bundles blocks;
    rsh_block block[16];
    uint node_tests, ray_tests;
} rsh_work;

/* What goes down the boxes together: some blocks of the tile, or one ray. */
typedef struct rsh_probe {
    rsh_bundle bundle;
    uint blocks;     /* bit mask */
    uint ray;        /* of the only block; 16: all its rays */
    int ray_sign[3]; /* that of all its rays per axis, or 0 */
} rsh_probe;

static uint lowest_bit(uint bits) { return 31 - clz(bits & -bits); }
static bool is_single(uint bits) { return (bits & (bits - 1)) == 0; }

static rsh_block* block_of(rsh_work* work, uint b)
{
    rsh_block* block = &work->block[b];
    if (work->loaded >> b & 1) return block;
    load_block(block, work->tile, b, work->rays);
    for (uint axis = 0; axis < 3; ++axis)
        block->bundle.slab[axis] =
            slab_of(work->nodes[16 * axis + b], work->nodes[48 + 16 * axis + b],
                    work->nodes[96 + 16 * axis + b], work->nodes[144 + 16 * axis + b]);
    work->loaded |= 1u << b;
    return block;
}

/* The block as a node; to be asked at once, before its limit changes. */
static const rsh_bundle* block_bundle(rsh_work* work, uint b)
{
    rsh_bundle* bundle = &block_of(work, b)->bundle;
    bundle->limit = lane_of(work->blocks.limit, b);
    return bundle;
}

static __global const float* group_of(const rsh_geometry_in* scene, uint level, uint group)
{
    return scene->boxes + RSH_GROUP_WORDS * (scene->levels.first_group[level] + group);
}

/* Boxes of a group that exist. */
static uint boxes_of(uint count, uint group)
{
    const uint left = count - 16 * group;
    return left < 16 ? (1u << left) - 1 : 0xffffu;
}

static void load_box(__global const float* group, uint k, float* low, float* high)
{
    for (uint axis = 0; axis < 3; ++axis) {
        low[axis] = group[16 * axis + k];
        high[axis] = group[48 + 16 * axis + k];
    }
}

/* How far the probe still has to look. */
static void lower_limit(rsh_work* work, rsh_probe* probe)
{
    if (is_single(probe->blocks)) {
        const uint b = lowest_bit(probe->blocks);
        probe->bundle.limit =
            probe->ray < 16
                ? lane_of(&work->block[b].ray[probe->ray / RSH_WIDTH].tmax,
                          probe->ray % RSH_WIDTH) *
                      RSH_RAISED
                : lane_of(work->blocks.limit, b);
        return;
    }
    floatv limit[RSH_VECTORS];
    for (uint v = 0; v < RSH_VECTORS; ++v) limit[v] = work->blocks.limit[v];
    for (uint b = 0; b < 16; ++b)
        if (!(probe->blocks >> b & 1)) ((float*)limit)[b] = -1.0f;
    probe->bundle.limit = largest_lane(limit);
}

static void update_limits(rsh_work* work, rsh_probe* probe, uint changed)
{
    for (; changed; changed &= changed - 1) {
        const uint b = lowest_bit(changed);
        const float limit = block_limit(&work->block[b]);
        if (!work->is_converging || limit < 0.0f) ((float*)work->blocks.limit)[b] = limit;
    }
    lower_limit(work, probe);
}

#endif
