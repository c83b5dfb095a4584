/* leaf.h - the triangles of a leaf against the rays of one block, or of many. */
#ifndef RSH_TRAVERSE_TILES_LEAF_H
#define RSH_TRAVERSE_TILES_LEAF_H

#include "traverse/tiles/state.h"
#include "tuning.h"

typedef struct loaded_leaf {
    __global const float* corners; /* see bvh_leaf */
    bool is_scaled;
    boxes16 boxes; /* of the triangles */
} loaded_leaf;

/* The boxes of its triangles are padded as rays/box_node.h says, by the largest component in
 * the leaf. */
RSH_CALLED static void load_leaf(const traversal_state* state, const bvh_child* box,
                                 loaded_leaf* leaf)
{
    leaf->corners = leaf_of(state, box->child);
    leaf->is_scaled = (box->child & RSH_SCALED) != 0;
    float reach = 0.0f;
    for (uint axis = 0; axis < 3; ++axis)
        reach = fmax(reach, fmax(fabs(box->low[axis]), fabs(box->high[axis])));
    const floatv pad = (floatv)(pad_of(reach));
    for (uint axis = 0; axis < 3; ++axis)
        for_each_vector(v) {
            __global const float* row = leaf->corners + 16 * axis + RSH_WIDTH * v;
            const floatv a = load_lanes(row), b = load_lanes(row + 48),
                         c = load_lanes(row + 96);
            leaf->boxes.low[axis][v] = lesser(a, lesser(b, c)) - pad;
            leaf->boxes.high[axis][v] = greater(a, greater(b, c)) + pad;
        }
}

RSH_CALLED static void intersect_triangle(traversal_state* state, const loaded_leaf* leaf,
                                          uint k, uint blocks)
{
    const leaf_triangle triangle = leaf_triangle_at(leaf->corners, k, leaf->is_scaled);
    for (; blocks; blocks &= blocks - 1) {
        const uint b = lowest_bit(blocks);
        count_for_blocks(state, &state->ray_tests, 1u << b, 1);
        if (intersect_packet(packet_of(state, b), &triangle, state->is_any))
            lower_block_limit(state, b);
    }
}

RSH_CALLED static void intersect_by_rays(traversal_state* state, const loaded_leaf* leaf,
                                         uint b, uint rays)
{
    ray_packet* packet = packet_of(state, b);
    bool changed = false;
    for (; rays; rays &= rays - 1) {
        const uint k = lowest_bit(rays);
        single_ray ray = single_ray_of(packet, k);
        count_for_ray(state, &state->ray_tests, b, k);
        if (!intersect_leaf(&ray, leaf->corners, leaf->is_scaled, state->is_any)) continue;
        store_single_ray(&ray, packet, k);
        changed = true;
    }
    if (changed) lower_block_limit(state, b);
}

/* Triangle by triangle against all rays of the block, or ray by ray against all triangles,
 * whichever are fewer. rays: those that meet the leaf; 0 if that is not known yet. */
RSH_CALLED static void intersect_loaded_leaf(traversal_state* state, const loaded_leaf* leaf,
                                             uint b, const int* sign, const bvh_child* box,
                                             uint rays)
{
    ray_packet* packet = packet_of(state, b);
    count_for_blocks(state, &state->node_tests, 1u << b, 16);
    uint triangles = boxes_met(interval_packet_of_block(state, b), &leaf->boxes, 0);
    const uint count = popcount(triangles);
    if (count > RSH_FEW_TRIANGLES && packet->is_fit) {
        if (!rays) {
            count_for_blocks(state, &state->node_tests, 1u << b, 1);
            rays = rays_meeting(packet, sign, box->low, box->high);
        }
        if (popcount(rays) < count) {
            intersect_by_rays(state, leaf, b, rays);
            return;
        }
    }
    for (; triangles; triangles &= triangles - 1)
        intersect_triangle(state, leaf, lowest_bit(triangles), 1u << b);
}

static void intersect_leaf_by_block(traversal_state* state, uint b, const int* sign,
                                    const bvh_child* box, uint rays)
{
    loaded_leaf leaf;
    load_leaf(state, box, &leaf);
    intersect_loaded_leaf(state, &leaf, b, sign, box, rays);
}

/* Many blocks: block by block, or each triangle looks for the blocks that meet it, whichever
 * are fewer. */
static void intersect_leaf_by_blocks(traversal_state* state, const interval_packet* common,
                                     const int* sign, const bvh_child* box, uint blocks)
{
    loaded_leaf leaf;
    load_leaf(state, box, &leaf);
    count_for_blocks(state, &state->node_tests, blocks, 16);
    uint triangles = boxes_met(common, &leaf.boxes, 0);
    if (popcount(triangles) >= popcount(blocks)) {
        for (; blocks; blocks &= blocks - 1)
            intersect_loaded_leaf(state, &leaf, lowest_bit(blocks), sign, box, 0);
        return;
    }
    for (; triangles; triangles &= triangles - 1) {
        const uint k = lowest_bit(triangles);
        float low[3], high[3];
        for (uint axis = 0; axis < 3; ++axis) {
            low[axis] = lane_of(leaf.boxes.low[axis], k);
            high[axis] = lane_of(leaf.boxes.high[axis], k);
        }
        count_for_blocks(state, &state->node_tests, blocks, 1);
        const uint met = packets_meeting(&state->blocks, common, low, high) & blocks;
        intersect_triangle(state, &leaf, k, met);
    }
}

#endif
