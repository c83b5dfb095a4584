/* scan_counts.cl - turns the counts of blocks into where their ranges begin: an exclusive
 * prefix sum by one work-group, for the strategies that count first.
 *   counts  in/out  `blocks` of them
 *   output_count[output_index]  out  their sum
 * Each work-item sums a range of its own, so that one scan of the group is enough.
 */
#include "lanes/lanes.h"
#include "reduce/scan.h"

RSH_CALLED static uint sum_of_counts(__global const uint* counts, uint begin, uint end)
{
    uint sum = 0;
    for (uint b = begin; b < end; ++b) sum += counts[b];
    return sum;
}

/* Counts become where ranges begin, the first one at `at`; returns where the last one ends. */
RSH_CALLED static uint place_ranges(__global uint* counts, uint begin, uint end, uint at)
{
    for (uint b = begin; b < end; ++b) {
        const uint count = counts[b];
        counts[b] = at;
        at += count;
    }
    return at;
}

__kernel void rsh_reduce_scan_counts(__global uint* counts, uint blocks,
                                     __global uint* output_count, uint output_index,
                                     __local uint* sums)
{
    const uint me = get_local_id(0), size = get_local_size(0);
    const uint range = blocks / size + (blocks % size != 0);
    const uint begin = (uint)min((ulong)me * range, (ulong)blocks);
    const uint end = begin + min(range, blocks - begin);
    const uint sum = sum_of_counts(counts, begin, end);
    const uint at = place_ranges(counts, begin, end, scan_group(sum, sums) - sum);
    if (me == size - 1) output_count[output_index] = at;
}
