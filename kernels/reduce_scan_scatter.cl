/* reduce_scan_scatter.cl - stream reduction by prefix sums: count per work-group, scan the
 * counts, then each group scans its flags and scatters. Stable.
 *   input, flags  in   the stream
 *   counts        scratch, one per work-group, then their exclusive prefix sums
 *   output        out  its kept elements, packed;  output_count[output_index]  out  how many
 * Full work-groups only; every barrier is reached by all work-items the same number of times.
 */
#include "reduce_element.h"

/* Inclusive prefix sum over the group (Hillis and Steele 1986), log2(group) steps. */
static uint scan_group(uint value, __local uint* sums)
{
    const uint me = get_local_id(0), size = get_local_size(0);
    sums[me] = value;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (uint step = 1; step < size; step *= 2) {
        const uint left = me >= step ? sums[me - step] : 0;
        barrier(CLK_LOCAL_MEM_FENCE);
        sums[me] += left;
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    return sums[me];
}

/* Blocks of one group's size that each group works off, the same number for all. */
static uint blocks_per_group(uint length)
{
    const uint stride = get_global_size(0);
    return length / stride + (length % stride != 0);
}

__kernel void rsh_reduce_scan_scatter_count(
    __global const uint* input, __global const uchar* flags, __global const uint* input_count,
    uint has_input_count, uint count, __global uint* counts, __local uint* sums)
{
    const uint length = stream_length(input_count, has_input_count, count);
    const uint size = get_local_size(0), blocks = blocks_per_group(length);
    ulong i = (ulong)get_group_id(0) * blocks * size + get_local_id(0);
    uint kept = 0;
    for (uint b = 0; b < blocks; ++b, i += size)
        if (i < length) kept += is_kept(input, flags, (uint)i);
    const uint inclusive = scan_group(kept, sums);
    if (get_local_id(0) == size - 1) counts[get_group_id(0)] = inclusive;
}

/* One work-group turns `groups` counts into exclusive prefix sums. */
__kernel void rsh_reduce_scan_scatter_scan(
    __global uint* counts, uint groups, __global uint* output_count, uint output_index,
    __local uint* sums)
{
    const uint me = get_local_id(0), size = get_local_size(0);
    uint total = 0;
    for (uint first = 0; first < groups; first += size) {
        const uint value = first + me < groups ? counts[first + me] : 0;
        const uint inclusive = scan_group(value, sums);
        if (first + me < groups) counts[first + me] = total + inclusive - value;
        total += sums[size - 1];
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    if (me == 0) output_count[output_index] = total;
}

__kernel void rsh_reduce_scan_scatter_write(
    __global const uint* input, __global const uchar* flags, __global const uint* input_count,
    uint has_input_count, uint count, __global const uint* counts, __global uint* output,
    __local uint* sums)
{
    const uint length = stream_length(input_count, has_input_count, count);
    const uint size = get_local_size(0), blocks = blocks_per_group(length);
    ulong i = (ulong)get_group_id(0) * blocks * size + get_local_id(0);
    uint at = counts[get_group_id(0)];
    for (uint b = 0; b < blocks; ++b, i += size) {
        const uint keep = i < length ? is_kept(input, flags, (uint)i) : 0;
        const uint inclusive = scan_group(keep, sums);
        if (keep) store_element(load_element((uint)i, input), at + inclusive - 1, output);
        at += sums[size - 1];
        barrier(CLK_LOCAL_MEM_FENCE);
    }
}
