/* sort.cl - sorts elements by their keys: a counting sort into bins, by the upper bits, then of
 * each bin by the lower bits. Elements with equal keys keep their order.
 *   sorting  in      see sort_plan
 *   keys     in      by element
 *   bins     in/out  per work-item of rsh_sort_scatter: how many of its elements are in a bin
 *   order    out     indices of the elements, from word `first` on
 */
#include "order/sort.h"

/* Turns counts into places: where a work-item's elements of a bin begin, behind all lower bins
 * and those of earlier work-items in this one. One work-item. */
__kernel void rsh_sort_scan(uint bin_count, __global const sort_plan* sorting,
                            __global uint* bins)
{
    if (get_global_id(0) != 0 || !sorting->is_needed) return;
    const uint items = sorting->items;
    uint sum = 0;
    for (uint b = 0; b < bin_count; ++b)
        for (uint i = 0; i < items; ++i) {
            __global uint* bin = bins + (ulong)bin_count * i + b;
            const uint elements = *bin;
            *bin = sum;
            sum += elements;
        }
}

static void load_keys(__global const uint* keys, uint count, uint* key)
{
    if (count == 16)
        for_each_vector(v) store_lanes(load_lanes(keys + RSH_WIDTH * v), key + RSH_WIDTH * v);
    else
        for (uint k = 0; k < count; ++k) key[k] = keys[k];
}

/* places: of each bin, where the next element goes. */
RSH_CALLED static void scatter(range16 mine, uint count, uint bin_shift,
                               __global const uint* keys, __global uint* places,
                               __global uint* order)
{
    for (uint g = mine.begin; g < mine.end; ++g) {
        const uint here = min(16u, count - 16 * g);
        uint key[16];
        load_keys(keys + 16 * g, here, key);
        if (here == 16 && are_in_one_bin(key, bin_shift)) {
            __global uint* at = order + places[key[0] >> bin_shift];
            for_each_vector(v)
                store_lanes(as_uintv(RSH_LANES) + (16 * g + RSH_WIDTH * v), at + RSH_WIDTH * v);
            places[key[0] >> bin_shift] += 16;
            continue;
        }
        for (uint k = 0; k < here; ++k) order[places[key[k] >> bin_shift]++] = 16 * g + k;
    }
}

__kernel void rsh_sort_scatter(uint bin_count, __global const sort_plan* sorting,
                               __global const uint* keys, __global uint* bins,
                               __global uint* order, ulong first)
{
    if (!sorting->is_needed) return;
    scatter(my_range16(sorting->count, sorting->items), sorting->count, sorting->bin_shift,
            keys, bins + (ulong)bin_count * get_global_id(0), order + first);
}

/* Values of a digit of six bits. */
#define RSH_DIGITS 64

RSH_CALLED static void sort_by_digit(__global uint* order, uint count,
                                     __global const uint* keys, uint shift, uint digits,
                                     __global uint* sorted)
{
    uint at[RSH_DIGITS], sum = 0;
    for (uint d = 0; d < digits; ++d) at[d] = 0;
    for (uint i = 0; i < count; ++i) ++at[keys[order[i]] >> shift & (digits - 1)];
    if (at[keys[order[0]] >> shift & (digits - 1)] == count) return; /* all have the same */
    for (uint d = 0; d < digits; ++d) {
        const uint here = at[d];
        at[d] = sum;
        sum += here;
    }
    for (uint i = 0; i < count; ++i)
        sorted[at[keys[order[i]] >> shift & (digits - 1)]++] = order[i];
    for (uint i = 0; i < count; ++i) order[i] = sorted[i];
}

/* A work-item sorts a range of bins. bins: as rsh_sort_scatter leaves them; the last
 * work-item's entry of a bin is where that bin ends. Up to 16 elements stay: they make a leaf
 * or a block anyway. */
__kernel void rsh_sort_refine(uint bin_count, __global const sort_plan* sorting,
                              __global const uint* keys, __global const uint* bins,
                              __global uint* sorted, __global uint* order, ulong first)
{
    const uint bin_shift = sorting->bin_shift;
    if (!sorting->is_needed || bin_shift == 0) return;
    const uint bins_per_item = (bin_count + get_global_size(0) - 1) / get_global_size(0);
    const uint first_bin = bins_per_item * (uint)get_global_id(0);
    __global const uint* end = bins + (ulong)bin_count * (sorting->items - 1);
    for (uint b = first_bin; b < min(first_bin + bins_per_item, bin_count); ++b) {
        const uint begin = b ? end[b - 1] : 0, count = end[b] - begin;
        if (count <= 16) continue;
        for (uint shift = 0; shift < bin_shift; shift += 6)
            sort_by_digit(order + first + begin, count, keys, shift,
                          min(64u, 1u << (bin_shift - shift)), sorted + begin);
    }
}
