/* descend_packet.h - takes one block of a tile through what is on the stack: its rays together,
 * or one by one where few of them meet a box.
 */
#ifndef RSH_TRAVERSE_TILES_DESCEND_PACKET_H
#define RSH_TRAVERSE_TILES_DESCEND_PACKET_H

#include "traverse/tiles/descend_ray.h"
#include "traverse/tiles/leaf.h"
#include "tuning.h"

/* A block on its way down. */
typedef struct block_packet {
    uint b;
    const int* sign; /* of all directions per axis; 0: they differ */
    uint wasted;     /* a visit that meets no ray adds 1, another one takes 1 off */
} block_packet;

RSH_CALLED static void visit_box_by_block(traversal_state* state, block_packet* block,
                                          const bvh_child* box)
{
    ray_packet* packet = packet_of(state, block->b);
    uint rays = 0; /* not known yet */
    if (packet->is_fit) {
        count_for_blocks(state, &state->node_tests, 1u << block->b, 1);
        rays = rays_meeting(packet, block->sign, box->low, box->high);
        const uint few = RSH_SPLIT_RAYS + block->wasted;
        block->wasted = rays ? block->wasted - (block->wasted > 0) : block->wasted + 1;
        if (popcount(rays) <= few) {
            for (; rays; rays &= rays - 1)
                traverse_ray(state, block->b, lowest_bit(rays), box->child);
            lower_block_limit(state, block->b);
            return;
        }
    }
    if (is_leaf(box->child))
        intersect_leaf_by_block(state, block->b, block->sign, box, rays);
    else
        push_boxes_met(state, interval_packet_of_block(state, block->b), 1u << block->b,
                       box->child);
}

/* Visits what lies on the stack above `bottom`. */
RSH_CALLED static void traverse_block(traversal_state* state, block_packet* block, uint bottom)
{
    while (state->stack_size > bottom) {
        const ulong top = state->stack[--state->stack_size];
        if (near_of(top) > lane_of(state->blocks.limit, block->b)) continue;
        const bvh_child box = load_box(state, name_of(top));
        if (is_passed_over(box.child)) continue;
        visit_box_by_block(state, block, &box);
    }
}

#endif
