/* sort.h - what kernels that sort have in common: elements go in groups of 16, a work-item has
 * a range of these groups; some of them are sampled before all get keys, which are places on a
 * grid.
 */
#ifndef RSH_ORDER_SORT_H
#define RSH_ORDER_SORT_H

#include "lanes/sixteen.h"
#include "order/types.h"
#include "tuning.h"

/* Elements 16 * begin to 16 * end - 1. */
typedef struct range16 {
    uint begin, end;
} range16;

/* Of `count` elements, those of this work-item, the last group of which may be short. items: that
 * share them; those launched beside them have none. */
static range16 my_range16(uint count, uint items)
{
    const uint sixteens = (count + 15) / 16;
    const uint per_item = (sixteens + items - 1) / items;
    const uint begin = min(sixteens, per_item * (uint)get_global_id(0));
    return (range16){begin, min(sixteens, begin + per_item)};
}

/* Whether all of 16 keys are in the bin of the first one, as those of neighbours mostly are. */
static bool are_in_one_bin(const uint* key, uint bin_shift)
{
    uint other = 0;
    for_each_vector(v) {
        const uintv bin = load_lanes(key + RSH_WIDTH * v) >> bin_shift;
        other |= RSH_LANE_BITS(bin != (uintv)(key[0] >> bin_shift));
    }
    return !other;
}

/* Stores the keys of group number `sixteen`, as many as there are, and counts them in their
 * bins. */
static void store_keys(const uint* key, uint sixteen, uint count, uint bin_shift,
                       __global uint* keys, __global uint* bins)
{
    if (16 * sixteen + 16 <= count && are_in_one_bin(key, bin_shift)) {
        for_each_vector(v)
            store_lanes(load_lanes(key + RSH_WIDTH * v), keys + 16 * sixteen + RSH_WIDTH * v);
        bins[key[0] >> bin_shift] += 16;
        return;
    }
    for (uint k = 0; k < 16 && 16 * sixteen + k < count; ++k) {
        keys[16 * sixteen + k] = key[k];
        ++bins[key[k] >> bin_shift];
    }
}

/* A work-item samples RSH_SAMPLES of its groups, or about. What lies outside of the box of all
 * samples is put into the cells at its margin. */
static uint sampling_step(range16 range) { return 1 + (range.end - range.begin) / RSH_SAMPLES; }

static sample_bounds empty_bounds(void)
{
    return (sample_bounds){
        {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, 0, 0};
}

/* The samples of `count` work-items; each work-item adds them up for itself. */
RSH_CALLED static sample_bounds merged_bounds(__global const sample_bounds* samples, uint count)
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

/* Cells per unit of length, where the longest side has 2^bits of them; 0 if it has no
 * length. */
static float cells_per_length(float longest, uint bits)
{
    const float cells = (float)((1u << bits) - 1);
    return longest > 0.0f && isfinite(longest) ? cells / longest : 0.0f;
}

/* Cell 0 to 2^bits - 1; the last one for NaN. */
static uintv cell_of(floatv at, float low, float scale, uint bits)
{
    const floatv last = (floatv)((float)((1u << bits) - 1));
    const floatv cell = lesser((at - low) * scale, last);
    return as_uintv(convert_intv(greater(cell, (floatv)(0.0f))));
}

#endif
