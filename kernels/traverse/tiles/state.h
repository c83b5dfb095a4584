/* state.h - what a work-item knows while it takes a tile through the scene: the scene, the
 * tile's blocks, and the stack of boxes that are still to be visited.
 */
#ifndef RSH_TRAVERSE_TILES_STATE_H
#define RSH_TRAVERSE_TILES_STATE_H

#include "traverse/tiles/single_ray_hits.h"

#ifndef RSH_TESTS_PER_RAY
#define RSH_TESTS_PER_RAY 0 /* 1: tests are counted ray by ray as well */
#endif

typedef struct bvh_view {
    __global const float* words;
    bvh_whole whole;
    uint top;     /* number of the topmost node */
    float leaves; /* how many, if all were full */
} bvh_view;

/* Tile, block and ray descents share one stack, one on top of the other. A node replaces an
 * entry by at most 16, so that a level adds at most 15; depth <= RSH_MAX_BVH_DEPTH. */
#define RSH_STACK (15 * RSH_MAX_BVH_DEPTH + 16)

typedef struct traversal_state {
    const bvh_view* scene;
    const triangles_left* rays;  /* and what they have left */
    __global const float* nodes; /* box_node16 of the tile */
    ray_tile tile;
    bool is_any;
    bool is_converging; /* nodes are seen from t = 1, backwards: a hit does not shorten them */
    uint loaded;        /* blocks whose packet is loaded, a bit each */
    float scene_size;   /* longest side of the scene's box */
    float leaf_size;    /* surface of the scene's box, per leaf */
    interval_packet16 blocks;
    ray_packet packet[16];
    ulong node_tests, ray_tests;
#if RSH_ALL_HITS
    hit_list list;
    hit_rows rows_of_block[16][RSH_VECTORS];
#endif
#if RSH_BATCHES
    __global const rsh_hit* hits;   /* of other batches */
    __global const uint* occlusion; /* likewise */
    uint occlusion_bit;
#endif
    /* With RSH_TESTS_PER_RAY: that all rays of a block took part in; that a ray did alone. */
    uint tests_of_block[RSH_TESTS_PER_RAY ? 16 : 1], tests_of_ray[RSH_TESTS_PER_RAY ? 256 : 1];
    uint stack_size;
    ulong stack[RSH_STACK]; /* bits of the t from which on, then what: near_of, name_of */
} traversal_state;

/* Sixteen tests of a stream, in which each ray of these blocks takes part `each` times. */
static void count_for_blocks(traversal_state* state, ulong* tests, uint blocks, uint each)
{
    *tests += 16;
    for (uint b = 0; RSH_TESTS_PER_RAY && b < 16; ++b)
        if (blocks >> b & 1) state->tests_of_block[b] += each;
}

/* Sixteen tests of ray k of block b. */
static void count_for_ray(traversal_state* state, ulong* tests, uint b, uint k)
{
    *tests += 16;
    if (RSH_TESTS_PER_RAY) state->tests_of_ray[16 * b + k] += 16;
}

static uint lowest_bit(uint bits) { return 31 - clz(bits & -bits); }
static bool is_single(uint bits) { return (bits & (bits - 1)) == 0; }

/* After the rays of the block have come to end earlier. */
static void lower_block_limit(traversal_state* state, uint b)
{
    if (RSH_ALL_HITS) return; /* no hit ends a ray */
    const float limit = packet_limit(&state->packet[b]);
    if (!state->is_converging || limit < 0.0f) ((float*)state->blocks.limit)[b] = limit;
}

#if RSH_BATCHES
static void continue_block(traversal_state* state, uint b)
{
    if (!state->rays->batch.is_continued) return;
    if (state->is_any)
        retire_hidden(&state->packet[b], state->occlusion, state->occlusion_bit);
    else
        continue_packet(&state->packet[b], state->rays, state->hits);
    lower_block_limit(state, b);
}
#endif

RSH_CALLED static void load_packet_of(traversal_state* state, uint b)
{
    ray_packet* packet = &state->packet[b];
    load_packet(packet, &state->tile, b, state->rays, state->scene_size);
#if RSH_ALL_HITS
    packet->rows = state->rows_of_block[b];
    for (uint v = 0; v < RSH_VECTORS; ++v) clear_rows(&packet->rows[v]);
    packet->list = &state->list;
#endif
    for (uint axis = 0; axis < 3; ++axis)
        packet->intervals.slab[axis] =
            slab_of(state->nodes[16 * axis + b], state->nodes[48 + 16 * axis + b],
                    state->nodes[96 + 16 * axis + b], state->nodes[144 + 16 * axis + b]);
    state->loaded |= 1u << b;
#if RSH_BATCHES
    continue_block(state, b);
#endif
}

static ray_packet* packet_of(traversal_state* state, uint b)
{
    if (!(state->loaded >> b & 1)) load_packet_of(state, b);
    return &state->packet[b];
}

/* The block as an interval packet; to be used at once, as its limit changes with each hit. */
static const interval_packet* interval_packet_of_block(traversal_state* state, uint b)
{
    interval_packet* packet = &packet_of(state, b)->intervals;
    packet->limit = lane_of(state->blocks.limit, b);
    return packet;
}

static __global const float* node_of(const traversal_state* state, uint node)
{
    return state->scene->words + node_at(&state->scene->whole, node);
}

static bool is_leaf(uint child) { return (child & RSH_IS_LEAF) != 0; }

/* Whether a slot that was met must not be visited: an empty one means leaf 0, whose hits would be
 * counted once more. */
static bool is_passed_over(uint child) { return RSH_ALL_HITS && child == RSH_NO_CHILD; }

/* child: bvh_node::child of a leaf. */
static __global const float* leaf_of(const traversal_state* state, uint child)
{
    return state->scene->words + leaf_at(RSH_CHILD_NUMBER(child));
}

/* A child and its box, out of a bvh_node. */
typedef struct bvh_child {
    uint child;
    float low[3], high[3];
} bvh_child;

static bvh_child load_box(const traversal_state* state, uint number)
{
    __global const float* at = node_of(state, number / 16) + number % 16;
    return (bvh_child){
        as_uint(at[RSH_CHILDREN_AT]), {at[0], at[16], at[32]}, {at[48], at[64], at[80]}};
}

static float near_of(ulong entry) { return as_float((uint)(entry >> 32)); }
static uint name_of(ulong entry) { return (uint)entry; }

/* Makes stack entries of the boxes of a node that were met, the nearest last; in any order where no
 * hit leaves out another. An entry is named by its slot, 16 * node + k, or, where `child` is not 0,
 * by the child itself. Returns how many. */
static uint sort_boxes(uint met, const float* near, uint node, __global const uint* child,
                       ulong* sorted)
{
    uint count = 0;
    for (; met; met &= met - 1) {
        const uint k = lowest_bit(met);
        const uint name = child ? child[k] : 16 * node + k;
        const ulong entry = RSH_ALL_HITS ? name : (ulong)as_uint(near[k]) << 32 | name;
        uint at = count++;
        for (; !RSH_ALL_HITS && at > 0 && sorted[at - 1] < entry; --at)
            sorted[at] = sorted[at - 1];
        sorted[at] = entry;
    }
    return count;
}

/* Asks for the rows of the children that were met. All of them: which are next shows when they are
 * sorted, and then there is no time left. */
static void expect_children(const traversal_state* state, uint met, __global const uint* child)
{
    for (; met; met &= met - 1) {
        const uint at = child[lowest_bit(met)];
        __global const float* row = is_leaf(at) ? leaf_of(state, at) : node_of(state, at);
        const uint rows = is_leaf(at) ? RSH_TRIANGLES_AT / 16 : RSH_CHILDREN_AT / 16 + 1;
        for (uint i = 0; i < rows; ++i) RSH_EXPECT_LOAD(row + 16 * i);
    }
}

/* Pushes the boxes of a node that the packet, of these blocks, can meet. */
RSH_CALLED static void push_boxes_met(traversal_state* state, const interval_packet* packet,
                                      uint blocks, uint node)
{
    float near[16];
    boxes16 boxes;
    __global const float* at = node_of(state, node);
    load_boxes(at, &boxes);
    count_for_blocks(state, &state->node_tests, blocks, 16);
    const uint met = boxes_met(packet, &boxes, near);
    expect_children(state, met, (__global const uint*)at + RSH_CHILDREN_AT);
    state->stack_size += sort_boxes(met, near, node, 0, state->stack + state->stack_size);
}

#endif
