/* packet_cost.h - the bounds of some blocks of a tile as one packet, and what it may cost to
 * take it through the scene.
 */
#ifndef RSH_TRAVERSE_TILES_PACKET_COST_H
#define RSH_TRAVERSE_TILES_PACKET_COST_H

#include "traverse/tiles/state.h"

/* Bounds of origins (axes 0 to 2) and directions (3 to 5) of some blocks, and their largest
 * tmax. */
typedef struct packet_bounds {
    float low[6], high[6], tmax;
} packet_bounds;

/* The rows of box_node16 that hold an axis. */
static uint low_row(uint axis) { return axis < 3 ? axis : axis + 3; }
static uint high_row(uint axis) { return low_row(axis) + 3; }

static floatv row_of(const traversal_state* state, uint row, uint v)
{
    return load_lanes(state->nodes + 16 * row + RSH_WIDTH * v);
}

RSH_CALLED static packet_bounds packet_bounds_of(const traversal_state* state, uint blocks)
{
    intv is_in[RSH_VECTORS];
    for_each_vector(v)
        is_in[v] = (((intv)((int)(blocks >> RSH_WIDTH * v)) >> RSH_LANES) & 1) != 0;
    packet_bounds bounds;
    floatv of[RSH_VECTORS];
    for (uint axis = 0; axis < 6; ++axis) {
        for_each_vector(v)
            of[v] = select((floatv)(INFINITY), row_of(state, low_row(axis), v), is_in[v]);
        bounds.low[axis] = smallest_lane(of);
        for_each_vector(v)
            of[v] = select((floatv)(-INFINITY), row_of(state, high_row(axis), v), is_in[v]);
        bounds.high[axis] = largest_lane(of);
    }
    for_each_vector(v) of[v] = select((floatv)(-1.0f), row_of(state, 12, v), is_in[v]);
    bounds.tmax = largest_lane(of);
    return bounds;
}

/* The cost, in leaves that are visited: the surface of the box that the rays fill at the far
 * end of the scene, by the scene's surface per leaf. side: of that box, cut to the size of the
 * scene; numbers or vectors, with their `lesser`. */
#define RSH_COST(side, size, leaf_size, lesser)        \
    ((lesser(side[0], size) * lesser(side[1], size) +  \
      lesser(side[1], size) * lesser(side[2], size) +  \
      lesser(side[2], size) * lesser(side[0], size)) / \
     (leaf_size))

static float cost_of(const traversal_state* state, const packet_bounds* bounds)
{
    float longest = 0.0f, side[3];
    for (uint axis = 3; axis < 6; ++axis)
        longest = fmax(longest, fmax(fabs(bounds->low[axis]), fabs(bounds->high[axis])));
    const float t = fmin(bounds->tmax, state->scene_size / longest);
    for (uint axis = 0; axis < 3; ++axis)
        side[axis] = bounds->high[axis] - bounds->low[axis] +
                     t * (bounds->high[3 + axis] - bounds->low[3 + axis]);
    return RSH_COST(side, state->scene_size, state->leaf_size, fmin);
}

/* The cost of each block on its own. */
RSH_CALLED static void costs_of_blocks(const traversal_state* state, float* cost)
{
    for_each_vector(v) {
        floatv longest = (floatv)(0.0f), side[3];
        for (uint axis = 3; axis < 6; ++axis)
            longest = greater(fabs(row_of(state, low_row(axis), v)),
                              greater(fabs(row_of(state, high_row(axis), v)), longest));
        const floatv size = (floatv)(state->scene_size);
        const floatv t = lesser(row_of(state, 12, v), size / longest);
        for (uint axis = 0; axis < 3; ++axis)
            side[axis] = row_of(state, high_row(axis), v) - row_of(state, low_row(axis), v) +
                         t * (row_of(state, high_row(3 + axis), v) -
                              row_of(state, low_row(3 + axis), v));
        store_lanes(RSH_COST(side, size, (floatv)(state->leaf_size), lesser),
                    cost + RSH_WIDTH * v);
    }
}

/* Made ready for the test against 16 boxes; the limit is not set. */
static interval_packet interval_packet_of(const packet_bounds* bounds)
{
    interval_packet packet;
    for (uint axis = 0; axis < 3; ++axis)
        packet.slab[axis] = slab_of(bounds->low[axis], bounds->high[axis],
                                    bounds->low[3 + axis], bounds->high[3 + axis]);
    return packet;
}

#endif
