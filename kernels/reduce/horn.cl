/* horn.cl - stream reduction by log-step compaction (Horn, GPU Gems 2, 2005, chapter
 * 36): the prefix sum of the dropped elements in log2 n passes over the whole stream, then each
 * place of the output searches for its element. O(n log n); kept for comparison. Stable.
 *   input, flags  in   the stream
 *   sums          scratch, one per element, twice: dropped elements up to and with element i
 *   output        out  its kept elements, packed;  output_count[output_index]  out  how many
 */
#include "lanes/stride.h"
#include "reduce/element.h"

__kernel void rsh_reduce_horn_begin(RSH_STREAM, __global uint* sums)
{
    const strided_range mine = my_elements(RSH_LENGTH);
    for (uint i = mine.begin; i < mine.end; i += mine.step)
        sums[i] = 1 - is_kept(input, flags, i);
}

__kernel void rsh_reduce_horn_step(RSH_STREAM, uint step, __global const uint* from,
                                   __global uint* to)
{
    const strided_range mine = my_elements(RSH_LENGTH);
    for (uint i = mine.begin; i < mine.end; i += mine.step)
        to[i] = from[i] + (i >= step ? from[i - step] : 0);
}

/* The first element with `wanted` kept ones in front of it that is kept itself: the first i
 * with i + 1 - sums[i] > wanted. */
static uint search_element(__global const uint* sums, uint length, uint wanted)
{
    uint low = wanted, high = length - 1;
    while (low < high) {
        const uint middle = low + (high - low) / 2;
        if (middle + 1 - sums[middle] > wanted)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

__kernel void rsh_reduce_horn_gather(RSH_STREAM, __global const uint* sums,
                                     __global uint* output, __global uint* output_count,
                                     uint output_index)
{
    const uint length = RSH_LENGTH;
    const uint kept = length > 0 ? length - sums[length - 1] : 0;
    if (get_global_id(0) == 0) output_count[output_index] = kept;
    const strided_range mine = my_elements(kept);
    for (uint i = mine.begin; i < mine.end; i += mine.step)
        store_element(load_element(search_element(sums, length, i), input), i, output);
}
