/* sort.h - what kernels that sort have in common: ranges of elements, a work-item each, in groups
 * of 16; and the grid that their places are on. */
#ifndef RSH_ORDER_SORT_H
#define RSH_ORDER_SORT_H

#include "lanes/sixteen.h"
#include "order/types.h"
#include "tuning.h"

typedef struct range16 {
    uint begin, end;
} range16;

static range16 my_range16(uint count)
{
    const uint sixteens = (count + 15) / 16, items = get_global_size(0);
    const uint per_item = (sixteens + items - 1) / items;
    const uint begin = min(sixteens, per_item * (uint)get_global_id(0));
    return (range16){begin, min(sixteens, begin + per_item)};
}

/* All of sixteen keys are in bin key[0] >> bin_shift, as neighbours mostly are. */
static bool are_in_one_bin(const uint* key, uint bin_shift)
{
    uint other = 0;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const uintv bin = load_lanes(key + RSH_WIDTH * v) >> bin_shift;
        other |= RSH_LANE_BITS(bin != (uintv)(key[0] >> bin_shift));
    }
    return !other;
}

/* Stores the keys of a group, as many as there are, and counts them in their bins. */
static void store_keys(const uint* key, uint sixteen, uint count, uint bin_shift,
                       __global uint* keys, __global uint* bins)
{
    if (16 * sixteen + 16 <= count && are_in_one_bin(key, bin_shift)) {
        for (uint v = 0; v < RSH_VECTORS; ++v)
            store_lanes(load_lanes(key + RSH_WIDTH * v), keys + 16 * sixteen + RSH_WIDTH * v);
        bins[key[0] >> bin_shift] += 16;
        return;
    }
    for (uint k = 0; k < 16 && 16 * sixteen + k < count; ++k) {
        keys[16 * sixteen + k] = key[k];
        ++bins[key[k] >> bin_shift];
    }
}

/* So many groups a work-item looks at before all elements get keys; those take what lies
 * outside of these groups for their margin. */
static uint sampling_step(range16 range) { return 1 + (range.end - range.begin) / RSH_SAMPLES; }

static sample_bounds empty_bounds(void)
{
    return (sample_bounds){
        {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, 0, 0};
}

/* What `count` work-items saw; each adds it up for itself. */
static sample_bounds merged_bounds(__global const sample_bounds* samples, uint count)
{
    sample_bounds whole = samples[0];
    for (uint i = 1; i < count; ++i) {
        for (uint axis = 0; axis < 3; ++axis) {
            whole.low[axis] = fmin(whole.low[axis], samples[i].low[axis]);
            whole.high[axis] = fmax(whole.high[axis], samples[i].high[axis]);
        }
        whole.sampled += samples[i].sampled;
        whole.incoherent += samples[i].incoherent;
    }
    return whole;
}

static float longest_side(const sample_bounds* bounds)
{
    float longest = 0.0f;
    for (uint axis = 0; axis < 3; ++axis)
        longest = fmax(longest, bounds->high[axis] - bounds->low[axis]);
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
