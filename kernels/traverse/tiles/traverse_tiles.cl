/* traverse_tiles.cl - a work-item finishes a tile of 256 rays: boxes of the scene front to
 * back, triangles last. Rays go down the tree together, as a tile packet, where that pays;
 * block by block where few blocks of the tile meet a box; ray by ray where few rays of a block
 * do.
 *   bvh        in      see bvh/layout.h
 *   skip       in      a triangle per ray that it does not hit; NULL: none
 *   list_count in      how many rays of a list there are, as for the nodes; NULL: all
 *   nodes      in      the blocks of the tiles (rays/build_boxes.cl)
 *   hits       out     closest
 *   occlusion  in/out  any: a bit per ray
 *   counts     in/out  if is_counting: tests of nodes, of rays
 *   tests_per_ray  in/out  with RSH_TESTS_PER_RAY: grows by the tests that each ray took part in
 * With RSH_ALL_HITS, hits and occlusion are what traverse/hit_list.h says; with RSH_BATCHES they may be
 * those of other batches, too (mesh/batch.h).
 * Each decision below only chooses between orders of the same tests, or leaves out tests that
 * cannot succeed. A work-item needs no memory but its stack, whose size is known.
 */
#include "lanes/stride.h"
#include "rays/levels.h"
#include "rays/nodes_head.h"
#include "traverse/count.h"
#include "traverse/tiles/descend_packet.h"
#include "traverse/tiles/pack_hits.h"
#include "traverse/tiles/packet_cost.h"
#include "traverse/wrong_buffers.h"
#include "tuning.h"

/* Blocks of the tile that go down the tree together. */
typedef struct tile_packet {
    interval_packet intervals;
    uint blocks; /* bit mask */
    int sign[3]; /* of all directions per axis; 0: they differ */
    uint wasted; /* a visit that meets no block adds 1, another one takes 1 off */
} tile_packet;

static tile_packet tile_packet_of(const traversal_state* state, uint blocks,
                                  const packet_bounds* bounds)
{
    tile_packet packet = {interval_packet_of(bounds), blocks, {0, 0, 0}, 0};
    for (uint axis = 0; axis < 3; ++axis) {
        const int sign = packet.intervals.slab[axis].sign;
        packet.sign[axis] = state->is_converging ? -sign : sign;
    }
    return packet;
}

/* No block of the packet has anything to find behind its limit. */
static void lower_limit(const traversal_state* state, tile_packet* packet)
{
    floatv limit[RSH_VECTORS];
    for_each_vector(v) limit[v] = state->blocks.limit[v];
    for (uint b = 0; b < 16; ++b)
        if (!(packet->blocks >> b & 1)) ((float*)limit)[b] = -1.0f;
    packet->intervals.limit = largest_lane(limit);
}

RSH_CALLED static void visit_box(traversal_state* state, tile_packet* packet,
                                 const bvh_child* box)
{
    count_for_blocks(state, &state->node_tests, packet->blocks, 1);
    uint blocks = packets_meeting(&state->blocks, &packet->intervals, box->low, box->high) &
                  packet->blocks;
    const uint few = RSH_SPLIT_BLOCKS + packet->wasted;
    packet->wasted = blocks ? packet->wasted - (packet->wasted > 0) : packet->wasted + 1;
    if (!blocks) return;
    if (popcount(blocks) > few && !is_leaf(box->child)) {
        push_boxes_met(state, &packet->intervals, packet->blocks, box->child);
        return;
    }
    if (popcount(blocks) > few)
        intersect_leaf_by_blocks(state, &packet->intervals, packet->sign, box, blocks);
    else
        for (; blocks; blocks &= blocks - 1) {
            block_packet block = {lowest_bit(blocks), packet->sign, 0};
            const uint bottom = state->stack_size;
            visit_box_by_block(state, &block, box);
            traverse_block(state, &block, bottom);
        }
    if (!RSH_ALL_HITS) lower_limit(state, packet); /* else no hit ends a ray */
}

RSH_CALLED static void traverse(traversal_state* state, uint blocks,
                                const packet_bounds* bounds)
{
    tile_packet packet = tile_packet_of(state, blocks, bounds);
    lower_limit(state, &packet);
    push_boxes_met(state, &packet.intervals, blocks, state->scene->top);
    if (is_single(blocks)) {
        block_packet block = {lowest_bit(blocks), packet.sign, 0};
        traverse_block(state, &block, 0);
        return;
    }
    while (state->stack_size) {
        const ulong top = state->stack[--state->stack_size];
        if (near_of(top) > packet.intervals.limit) continue;
        const bvh_child box = load_box(state, name_of(top));
        if (is_passed_over(box.child)) continue;
        visit_box(state, &packet, &box);
    }
}

static bool is_incoherent(const traversal_state* state, float cost)
{
    return cost >= RSH_INCOHERENT_SHARE * state->scene->leaves;
}

/* Together, if that costs no more than block by block. */
RSH_CALLED static bool traverse_together(traversal_state* state, uint blocks, const float* cost)
{
    const packet_bounds bounds = packet_bounds_of(state, blocks);
    float apart = 0.0f, together = RSH_PACKET_COST + cost_of(state, &bounds);
    for (uint left = blocks; left; left &= left - 1) {
        const float alone = cost[lowest_bit(left)];
        apart += is_incoherent(state, alone) ? 16.0f * RSH_RAY_COST : RSH_PACKET_COST + alone;
        together += alone; /* at the leaves, each block still does its own tests */
    }
    if (together > apart) return false;
    traverse(state, blocks, &bounds);
    return true;
}

RSH_CALLED static void traverse_apart(traversal_state* state, uint blocks, const float* cost)
{
    for (; blocks; blocks &= blocks - 1) {
        const uint b = lowest_bit(blocks);
        if (is_incoherent(state, cost[b]) && packet_of(state, b)->is_fit) {
            traverse_rays(state, b);
        } else {
            const packet_bounds bounds = packet_bounds_of(state, 1u << b);
            traverse(state, 1u << b, &bounds);
        }
    }
}

/* A tile whose rays have little in common, as at the edge between two mirrors, is split into
 * quarters, these into blocks, these into rays. */
RSH_CALLED static void traverse_tile(traversal_state* state, uint active)
{
    float cost[16];
    costs_of_blocks(state, cost);
    if (traverse_together(state, active, cost)) return;
    for (uint quarter = 0; quarter < 4; ++quarter) {
        const uint blocks = active & (0x0033u << (quarter / 2 * 8 + quarter % 2 * 2));
        if (blocks && !traverse_together(state, blocks, cost))
            traverse_apart(state, blocks, cost);
    }
}

/* Whether the tile may meet what there is. Asked only of batches of a scene, as most tiles meet few of
 * these. */
static bool meets_batch(const traversal_state* state, uint active)
{
#if RSH_BATCHES
    const packet_bounds bounds = packet_bounds_of(state, active);
    interval_packet packet = interval_packet_of(&bounds);
    packet.limit = bounds.tmax * RSH_RAISED;
    boxes16 top;
    load_boxes(node_of(state, state->scene->top), &top);
    return boxes_met(&packet, &top, 0) != 0;
#else
    (void)state, (void)active;
    return true;
#endif
}

/* Returns the blocks that hold an active ray, a bit each; none: the tile meets nothing. */
RSH_CALLED static uint begin_tile(traversal_state* state)
{
    uint active = 0;
    for_each_vector(v) {
        state->blocks.limit[v] =
            load_lanes(state->nodes + 16 * 12 + RSH_WIDTH * v) * RSH_RAISED;
        active |= RSH_LANE_BITS(state->blocks.limit[v] >= (floatv)(0.0f)) << (RSH_WIDTH * v);
    }
    state->is_converging = as_uint(state->nodes[16 * 13]) != 0;
    if (!active || !meets_batch(state, active)) return 0;
    for (uint axis = 0; axis < 3; ++axis)
        for_each_vector(v) {
            floatv row[4];
            for (uint f = 0; f < 4; ++f)
                row[f] = load_lanes(state->nodes + 16 * (3 * f + axis) + RSH_WIDTH * v);
            set_packets_axis(&state->blocks, axis, v, row[0], row[1], row[2], row[3]);
        }
    return active;
}

static void clear_tests_per_ray(traversal_state* state)
{
    for (uint b = 0; RSH_TESTS_PER_RAY && b < 16; ++b) state->tests_of_block[b] = 0;
    for (uint i = 0; RSH_TESTS_PER_RAY && i < 256; ++i) state->tests_of_ray[i] = 0;
}

/* The tile has found nothing yet. */
static uint begin_nothing(traversal_state* state)
{
    state->node_tests = state->ray_tests = 0;
    state->loaded = state->stack_size = 0;
    return 0;
}

RSH_CALLED static void measure_scene(traversal_state* state)
{
    boxes16 top;
    float side[3];
    load_boxes(node_of(state, state->scene->top), &top);
    for (uint axis = 0; axis < 3; ++axis)
        side[axis] = largest_lane(top.high[axis]) - smallest_lane(top.low[axis]);
    state->scene_size = fmax(side[0], fmax(side[1], side[2]));
    const float surface = side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
    state->leaf_size = surface / state->scene->leaves;
}

/* Whether answers hold what other batches of the scene have found. */
static bool is_continued(const traversal_state* state)
{
#if RSH_BATCHES
    return state->rays->batch.is_continued != 0;
#else
    (void)state;
    return false;
#endif
}

#if RSH_ALL_HITS
RSH_CALLED static void store_answers(traversal_state* state, uint tile, __global uint* counts)
{
    for (uint b = 0; b < 16; ++b)
        store_packet_counts(state->loaded >> b & 1 ? &state->packet[b] : 0, state->tile, b,
                            counts);
    if (!state->list.records) return;
    pack_hits(state, tile);
    close_list(&state->list);
}
#else
RSH_CALLED static void store_answers(const traversal_state* state, __global rsh_hit* hits,
                                     __global uint* occlusion, uint occlusion_bit)
{
    for (uint b = 0; b < 16; ++b) {
        const bool is_loaded = state->loaded >> b & 1;
        if (state->is_any && is_loaded)
            store_packet_occlusion(&state->packet[b], state->tile, b, occlusion, occlusion_bit);
        else if (!state->is_any && is_loaded)
            store_continued_hits(&state->packet[b], state->rays, hits);
        else if (!state->is_any && !is_continued(state))
            store_misses(state->tile, b, state->rays->rays, hits);
    }
}
#endif

/* The tests that each active ray took part in. */
static void add_tests_per_ray(const traversal_state* state, __global uint* tests_per_ray)
{
    for (uint i = 0; RSH_TESTS_PER_RAY && i < 256; ++i) {
        const uint ray = ray_of(state->tile, i / 16, i % 16);
        if (ray != RSH_NO_RAY && is_active(state->rays->rays[ray]))
            tests_per_ray[ray] += state->tests_of_block[i / 16] + state->tests_of_ray[i];
    }
}

RSH_FILLS_VECTORS
__kernel void rsh_traverse_tiles(
    bvh_whole whole, __global const float* bvh, mesh_view mesh, __global const float* vertices,
    __global const uint* indices, ray_levels shape, __global const uint* list_count,
    __global const rsh_ray* rays, __global const uint* skip, __global const float* nodes,
    __global rsh_hit* hits, __global uint* occlusion, uint occlusion_bit, uint is_counting,
    __global uint* counts, __global uint* tests_per_ray,
    volatile __global uint* wrong RSH_FILTER_PARAMETERS RSH_BATCH_PARAMETERS)
{
    const ray_levels levels = counted_levels(shape, list_count);
    const uint me = my_element(tile_count(levels));
    if (me == tile_count(levels)) return; /* the launch is for all places */
    bvh_view scene;
    scene.whole = whole;
    scene.words = bvh;
    scene.leaves = (float)((whole.triangles + 15) / 16);
    traversal_state state;
    state.scene = &scene;
    const triangles_left left = {mesh, vertices, indices, rays,
                                 skip RSH_GIVEN_FILTER RSH_GIVEN_BATCH};
    state.rays = &left;
    state.nodes = nodes + RSH_NODES_HEAD_WORDS + 16ul * RSH_NODE_ROWS * me;
    state.is_any = !RSH_ALL_HITS && occlusion_bit != 0;
#if RSH_ALL_HITS
    state.list = hit_list_in(hits, occlusion_bit, RSH_RECORDS_AT_ONCE);
#endif
#if RSH_BATCHES
    state.hits = hits;
    state.occlusion = occlusion;
    state.occlusion_bit = occlusion_bit;
#endif
    clear_tests_per_ray(&state);
    const bool is_right =
        are_right(!whole.triangles || are_made_of(bvh, whole),
                  nodes_are_of(shape, levels.width[0], RSH_BOXES_MADE, nodes), wrong);
    state.tile = tile_at(levels, is_right ? order_in(nodes) : 0, me);
    uint active = begin_nothing(&state);
    if (is_right && whole.triangles) {
        scene.top = top_node(bvh, whole);
        active = begin_tile(&state);
    }
    if (active) {
        measure_scene(&state);
        traverse_tile(&state, active);
    }
#if RSH_ALL_HITS
    store_answers(&state, me, occlusion);
#else
    store_answers(&state, hits, occlusion, occlusion_bit);
#endif
    add_tests_per_ray(&state, tests_per_ray);
    if (!is_counting) return;
    add_to_count(counts, state.node_tests);
    add_to_count(counts + 2, state.ray_tests);
}
