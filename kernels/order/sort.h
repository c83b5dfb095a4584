/* sort.h - what kernels that sort have in common: runs of elements, a work-item each, in groups
 * of 16; and the grid that their places are on. */
#ifndef RSH_ORDER_SORT_H
#define RSH_ORDER_SORT_H

#include "lanes/sixteen.h"
#include "order/types.h"

typedef struct rsh_part {
    uint begin, end;
} rsh_part;

static rsh_part my_groups(uint count)
{
    const uint groups = (count + 15) / 16, items = get_global_size(0);
    const uint run = (groups + items - 1) / items;
    const uint begin = min(groups, run * (uint)get_global_id(0));
    return (rsh_part){begin, min(groups, begin + run)};
}

/* All of sixteen keys are in bin key[0] >> rest, as neighbours mostly are. */
static bool are_in_one_bin(const uint* key, uint rest)
{
    uint other = 0;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const uintv bin = load_lanes(key + RSH_WIDTH * v) >> rest;
        other |= RSH_LANE_BITS(bin != (uintv)(key[0] >> rest));
    }
    return !other;
}

/* Stores the keys of a group, as many as there are, and counts them in their bins. */
static void store_keys(const uint* key, uint group, uint count, uint rest, __global uint* keys,
                       __global uint* bins)
{
    if (16 * group + 16 <= count && are_in_one_bin(key, rest)) {
        for (uint v = 0; v < RSH_VECTORS; ++v)
            store_lanes(load_lanes(key + RSH_WIDTH * v), keys + 16 * group + RSH_WIDTH * v);
        bins[key[0] >> rest] += 16;
        return;
    }
    for (uint k = 0; k < 16 && 16 * group + k < count; ++k) {
        keys[16 * group + k] = key[k];
        ++bins[key[k] >> rest];
    }
}

/* So many groups a work-item looks at before all elements get keys; those take what lies
 * outside of these groups for their margin. */
#define RSH_ASKED 64

static uint asking_step(rsh_part groups) { return 1 + (groups.end - groups.begin) / RSH_ASKED; }

static rsh_span no_span(void)
{
    return (rsh_span){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, 0, 0};
}

/* What `count` work-items saw; each adds it up for itself. */
static rsh_span whole_span(__global const rsh_span* spans, uint count)
{
    rsh_span whole = spans[0];
    for (uint i = 1; i < count; ++i) {
        for (uint axis = 0; axis < 3; ++axis) {
            whole.low[axis] = fmin(whole.low[axis], spans[i].low[axis]);
            whole.high[axis] = fmax(whole.high[axis], spans[i].high[axis]);
        }
        whole.asked += spans[i].asked;
        whole.sparse += spans[i].sparse;
    }
    return whole;
}

static float longest_side(const rsh_span* span)
{
    float longest = 0.0f;
    for (uint axis = 0; axis < 3; ++axis)
        longest = fmax(longest, span->high[axis] - span->low[axis]);
    return longest;
}

/* Cells per unit of length, for 2^bits along the longest side. */
static float cells_per_length(float longest, uint bits)
{
    const float cells = (float)((1u << bits) - 1);
    return longest > 0.0f && isfinite(longest) ? cells / longest : 0.0f;
}

/* Cells 0 to 2^bits - 1; whatever is not a number goes to the last. */
static uintv cell_of(floatv at, float low, float scale, uint bits)
{
    const floatv last = (floatv)((float)((1u << bits) - 1));
    const floatv cell = lesser((at - low) * scale, last);
    return as_uintv(convert_intv(greater(cell, (floatv)(0.0f))));
}

#endif
