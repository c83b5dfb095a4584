/* state.h - what a work-item knows while it takes a tile through the scene: the scene, the
 * tile's blocks, and the boxes that are still to be visited. */
#ifndef RSH_TRAVERSE_TILES_STATE_H
#define RSH_TRAVERSE_TILES_STATE_H

#include "traverse/tiles/single_ray.h"

typedef struct rsh_scene_in {
    __global const float* boxes;
    rsh_scene_shape shape;
    uint top;       /* group */
    float clusters; /* about how many */
} rsh_scene_in;

/* What tile, block and ray, which go on where the one before left, may leave on the stack: 15
 * boxes of each group on the way down. */
#define RSH_STACK (15 * RSH_MAX_BOX_DEPTH + 16)

typedef struct rsh_work {
    const rsh_scene_in* scene;
    __global const rsh_ray* rays;
    __global const float* nodes; /* of the tile */
    rsh_tile tile;
    bool is_any;
    bool is_converging; /* nodes run backwards: a hit is no limit to them */
    uint loaded;        /* blocks */
    float scene_size;   /* longest side */
    float cluster_size; /* surface of the scene's box, by clusters */
    rsh_bundles blocks;
    rsh_block block[16];
    uint node_tests, ray_tests;
    uint stack_size;
    ulong stack[RSH_STACK]; /* from which t on (its bits), name */
} rsh_work;

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

/* After hits of a block's rays. */
static void lower_block_limit(rsh_work* work, uint b)
{
    const float limit = block_limit(&work->block[b]);
    if (!work->is_converging || limit < 0.0f) ((float*)work->blocks.limit)[b] = limit;
}

static __global const float* group_of(const rsh_work* work, uint group)
{
    return work->scene->boxes + box_group_at(&work->scene->shape, group);
}

static bool is_cluster(uint below) { return (below & RSH_IS_CLUSTER) != 0; }

/* below: of a box around a cluster. */
static __global const float* cluster_of(const rsh_work* work, uint below)
{
    return work->scene->boxes + cluster_at(RSH_BELOW_NUMBER(below));
}

/* A box and what is below it, as in rsh_box_group; its sides [axis]. */
typedef struct rsh_box {
    uint below;
    float low[3], high[3];
} rsh_box;

static rsh_box load_box(const rsh_work* work, uint number)
{
    __global const float* at = group_of(work, number / 16) + number % 16;
    return (rsh_box){
        as_uint(at[RSH_BELOW_AT]), {at[0], at[16], at[32]}, {at[48], at[64], at[80]}};
}

static float near_of(ulong entry) { return as_float((uint)(entry >> 32)); }
static uint name_of(ulong entry) { return (uint)entry; }

/* Boxes of a group that were met, as entries of the stack, the nearest last: by their numbers,
 * 16 * group + k, or, if `below` is not 0, by what is below them. Returns how many. */
static uint sort_boxes(uint met, const float* near, uint group, __global const uint* below,
                       ulong* sorted)
{
    uint count = 0;
    for (; met; met &= met - 1) {
        const uint k = lowest_bit(met);
        const uint name = below ? below[k] : 16 * group + k;
        const ulong entry = (ulong)as_uint(near[k]) << 32 | name;
        uint at = count++;
        for (; at > 0 && sorted[at - 1] < entry; --at) sorted[at] = sorted[at - 1];
        sorted[at] = entry;
    }
    return count;
}

/* Puts the boxes of a group that the bundle can meet onto the stack. */
static void push_boxes_met(rsh_work* work, const rsh_bundle* bundle, uint group)
{
    float near[16];
    rsh_boxes boxes;
    load_boxes(group_of(work, group), &boxes);
    work->node_tests += 16;
    const uint met = boxes_met(bundle, &boxes, near);
    work->stack_size += sort_boxes(met, near, group, 0, work->stack + work->stack_size);
}

#endif
