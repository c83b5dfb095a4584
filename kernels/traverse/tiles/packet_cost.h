/* packet_cost.h - some blocks of a tile as one node, and what it may cost to take it through the
 * scene. */
#ifndef RSH_TRAVERSE_TILES_PACKET_COST_H
#define RSH_TRAVERSE_TILES_PACKET_COST_H

#include "traverse/tiles/state.h"

/* Origins (axes 0 to 2) and directions (3 to 5) of some blocks, and how far they reach. */
typedef struct rsh_hull {
    float low[6], high[6], tmax;
} rsh_hull;

/* Rows of rsh_node_group. */
static uint low_row(uint axis) { return axis < 3 ? axis : axis + 3; }
static uint high_row(uint axis) { return low_row(axis) + 3; }

static floatv row_of(const rsh_work* work, uint row, uint v)
{
    return load_lanes(work->nodes + 16 * row + RSH_WIDTH * v);
}

static rsh_hull hull_of(const rsh_work* work, uint blocks)
{
    intv is_in[RSH_VECTORS];
    for (uint v = 0; v < RSH_VECTORS; ++v)
        is_in[v] = (((intv)((int)(blocks >> RSH_WIDTH * v)) >> RSH_LANES) & 1) != 0;
    rsh_hull hull;
    floatv of[RSH_VECTORS];
    for (uint axis = 0; axis < 6; ++axis) {
        for (uint v = 0; v < RSH_VECTORS; ++v)
            of[v] = select((floatv)(INFINITY), row_of(work, low_row(axis), v), is_in[v]);
        hull.low[axis] = smallest_lane(of);
        for (uint v = 0; v < RSH_VECTORS; ++v)
            of[v] = select((floatv)(-INFINITY), row_of(work, high_row(axis), v), is_in[v]);
        hull.high[axis] = largest_lane(of);
    }
    for (uint v = 0; v < RSH_VECTORS; ++v)
        of[v] = select((floatv)(-1.0f), row_of(work, 12, v), is_in[v]);
    hull.tmax = largest_lane(of);
    return hull;
}

/* The cost, in clusters met: the share that the box which the rays fill at the scene's far end
 * has of the scene's surface. side: of that box; numbers or vectors, with their `lesser`. */
#define RSH_COST(side, size, cluster_size, lesser)     \
    ((lesser(side[0], size) * lesser(side[1], size) +  \
      lesser(side[1], size) * lesser(side[2], size) +  \
      lesser(side[2], size) * lesser(side[0], size)) / \
     (cluster_size))

static float cost_of(const rsh_work* work, const rsh_hull* hull)
{
    float longest = 0.0f, side[3];
    for (uint axis = 3; axis < 6; ++axis)
        longest = fmax(longest, fmax(fabs(hull->low[axis]), fabs(hull->high[axis])));
    const float t = fmin(hull->tmax, work->scene_size / longest);
    for (uint axis = 0; axis < 3; ++axis)
        side[axis] = hull->high[axis] - hull->low[axis] +
                     t * (hull->high[3 + axis] - hull->low[3 + axis]);
    return RSH_COST(side, work->scene_size, work->cluster_size, fmin);
}

/* Of each block alone. */
static void costs_of_blocks(const rsh_work* work, float* cost)
{
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        floatv longest = (floatv)(0.0f), side[3];
        for (uint axis = 3; axis < 6; ++axis)
            longest = greater(fabs(row_of(work, low_row(axis), v)),
                              greater(fabs(row_of(work, high_row(axis), v)), longest));
        const floatv size = (floatv)(work->scene_size);
        const floatv t = lesser(row_of(work, 12, v), size / longest);
        for (uint axis = 0; axis < 3; ++axis)
            side[axis] =
                row_of(work, high_row(axis), v) - row_of(work, low_row(axis), v) +
                t * (row_of(work, high_row(3 + axis), v) - row_of(work, low_row(3 + axis), v));
        store_lanes(RSH_COST(side, size, (floatv)(work->cluster_size), lesser),
                    cost + RSH_WIDTH * v);
    }
}

/* The hull against 16 boxes; without a limit. */
static rsh_bundle bundle_of(const rsh_hull* hull)
{
    rsh_bundle bundle;
    for (uint axis = 0; axis < 3; ++axis)
        bundle.slab[axis] = slab_of(hull->low[axis], hull->high[axis], hull->low[3 + axis],
                                    hull->high[3 + axis]);
    return bundle;
}

#endif
