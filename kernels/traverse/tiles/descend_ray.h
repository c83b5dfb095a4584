/* descend_ray.h - takes rays of a block one by one through the whole scene, or through what
 * lies in one box. Their entries on the stack name the child itself (bvh_node::child), not its
 * slot.
 */
#ifndef RSH_TRAVERSE_TILES_DESCEND_RAY_H
#define RSH_TRAVERSE_TILES_DESCEND_RAY_H

#include "traverse/tiles/state.h"

/* Ray k of block b through a child: a leaf, or a node and all below it. */
RSH_CALLED static void traverse_ray(traversal_state* state, uint b, uint k, uint child)
{
    ray_packet* packet = packet_of(state, b);
    single_ray ray = single_ray_of(packet, k);
    const uint bottom = state->stack_size;
    state->stack[state->stack_size++] = child;
    bool changed = false;
    while (state->stack_size > bottom) {
        const ulong top = state->stack[--state->stack_size];
        if (near_of(top) > ray.limit) continue;
        const uint at = name_of(top);
        if (is_passed_over(at)) continue;
        if (is_leaf(at)) {
            count_for_ray(state, &state->ray_tests, b, k);
            changed |=
                intersect_leaf(&ray, leaf_of(state, at), (at & RSH_SCALED) != 0, state->is_any);
            continue;
        }
        __global const float* node = node_of(state, at);
        float near[16];
        count_for_ray(state, &state->node_tests, b, k);
        __global const uint* children = (__global const uint*)node + RSH_CHILDREN_AT;
        const uint met = boxes_met_by_ray(&ray, node, near);
        expect_children(state, met, children);
        state->stack_size +=
            sort_boxes(met, near, 0, children, state->stack + state->stack_size);
    }
    if (changed) store_single_ray(&ray, packet, k);
}

/* All rays of block b through the whole scene. */
RSH_CALLED static void traverse_rays(traversal_state* state, uint b)
{
    for (uint k = 0; k < 16; ++k)
        if (lane_of(&packet_of(state, b)->ray[k / RSH_WIDTH].tmax, k % RSH_WIDTH) >= 0.0f)
            traverse_ray(state, b, k, state->scene->top);
}

#endif
