/* tile_probe.h - some blocks of a tile as one probe, and what it may cost to send it. */
#ifndef RSH_TILE_PROBE_H
#define RSH_TILE_PROBE_H

#include "tile_work.h"

/* What going down the boxes costs besides what is met there, in clusters met. */
#define RSH_START 20.0f

/* Rows of the tile's nodes, of some of its blocks only: the others hold nothing. */
static float lowest_of(const rsh_work* work, uint row, uint blocks)
{
    float low = INFINITY;
    for (; blocks; blocks &= blocks - 1)
        low = fmin(low, work->nodes[16 * row + lowest_bit(blocks)]);
    return low;
}

static float highest_of(const rsh_work* work, uint row, uint blocks)
{
    float high = -INFINITY;
    for (; blocks; blocks &= blocks - 1)
        high = fmax(high, work->nodes[16 * row + lowest_bit(blocks)]);
    return high;
}

/* What it may cost to take the blocks through the scene together, in clusters met: their share
 * of the surface of the box that the rays fill at the scene's far end. */
static float cost_of(const rsh_work* work, uint blocks)
{
    float low[6], high[6], longest = 0.0f;
    for (uint axis = 0; axis < 3; ++axis) {
        low[axis] = lowest_of(work, axis, blocks);
        high[axis] = highest_of(work, 3 + axis, blocks);
        low[3 + axis] = lowest_of(work, 6 + axis, blocks);
        high[3 + axis] = highest_of(work, 9 + axis, blocks);
        longest = fmax(longest, fmax(fabs(low[3 + axis]), fabs(high[3 + axis])));
    }
    const float t = fmin(highest_of(work, 12, blocks), work->scene_size / longest);
    float side[3];
    for (uint axis = 0; axis < 3; ++axis)
        side[axis] = fmin(high[axis] - low[axis] + t * (high[3 + axis] - low[3 + axis]),
                          work->scene_size);
    return RSH_START +
           (side[0] * side[1] + side[1] * side[2] + side[2] * side[0]) / work->cluster_size;
}

static rsh_probe probe_of(rsh_work* work, uint blocks)
{
    rsh_probe probe;
    probe.blocks = blocks;
    probe.ray = 16;
    for (uint axis = 0; axis < 3; ++axis) {
        probe.bundle.slab[axis] =
            slab_of(lowest_of(work, axis, blocks), highest_of(work, 3 + axis, blocks),
                    lowest_of(work, 6 + axis, blocks), highest_of(work, 9 + axis, blocks));
        const int sign = probe.bundle.slab[axis].sign;
        probe.ray_sign[axis] = work->is_converging ? -sign : sign;
    }
    lower_limit(work, &probe);
    return probe;
}

#endif
