/* scan_counts.cl - turns the counts of blocks into where their ranges begin: an exclusive
 * prefix sum by one work-group, for the strategies that count first.
 *   counts  in/out  `blocks` of them
 *   output_count[output_index]  out  their sum
 * Each work-item sums a range of its own, so that one scan of the group is enough.
 */
#include "reduce/scan.h"

__kernel void rsh_reduce_scan_counts(__global uint* counts, uint blocks,
                                     __global uint* output_count, uint output_index,
                                     __local uint* sums)
{
    const uint me = get_local_id(0), size = get_local_size(0);
    const uint range = blocks / size + (blocks % size != 0);
    const uint begin = (uint)min((ulong)me * range, (ulong)blocks);
    const uint end = begin + min(range, blocks - begin);
    uint sum = 0;
    for (uint b = begin; b < end; ++b) sum += counts[b];
    uint at = scan_group(sum, sums) - sum;
    for (uint b = begin; b < end; ++b) {
        const uint count = counts[b];
        counts[b] = at;
        at += count;
    }
    if (me == size - 1) output_count[output_index] = at;
}
