/* blelloch.cl - stream reduction by the work-efficient prefix sum (Blelloch 1990): up
 * and down a balanced tree over the whole stream, 2 log2 n launches, then a scatter. O(n); kept
 * for comparison. Stable.
 *   input, flags  in   the stream
 *   sums          scratch, a power of two of them: the tree in place
 *   output        out  its kept elements, packed;  output_count[output_index]  out  how many
 */
#include "lanes/stride.h"
#include "reduce/element.h"

/* Leaves of the tree over `length` elements: the next power of two. */
static uint leaves_of(uint length) { return length <= 1 ? 1u : 1u << (32 - clz(length - 1)); }

__kernel void rsh_reduce_blelloch_begin(RSH_STREAM, __global uint* sums)
{
    const uint length = RSH_LENGTH;
    const strided_range mine = my_elements(leaves_of(length));
    for (uint i = mine.begin; i < mine.end; i += mine.step)
        sums[i] = i < length ? is_kept(input, flags, i) : 0;
}

/* Nodes of 2 * half leaves: the last leaf's place takes the sum of both halves. */
__kernel void rsh_reduce_blelloch_up(RSH_STREAM, uint half_leaves, __global uint* sums)
{
    const strided_range mine = my_elements(leaves_of(RSH_LENGTH) / 2 / half_leaves);
    for (uint n = mine.begin; n < mine.end; n += mine.step) {
        __global uint* node = sums + (ulong)n * 2 * half_leaves;
        node[2 * half_leaves - 1] += node[half_leaves - 1];
    }
}

__kernel void rsh_reduce_blelloch_root(RSH_STREAM, __global uint* sums,
                                       __global uint* output_count, uint output_index)
{
    const uint root = leaves_of(RSH_LENGTH) - 1;
    output_count[output_index] = sums[root];
    sums[root] = 0;
}

/* A node knows what is in front of it: so does its left half, and its right one by adding the
 * left one's sum. */
__kernel void rsh_reduce_blelloch_down(RSH_STREAM, uint half_leaves, __global uint* sums)
{
    const strided_range mine = my_elements(leaves_of(RSH_LENGTH) / 2 / half_leaves);
    for (uint n = mine.begin; n < mine.end; n += mine.step) {
        __global uint* node = sums + (ulong)n * 2 * half_leaves;
        const uint left = node[half_leaves - 1], before = node[2 * half_leaves - 1];
        node[half_leaves - 1] = before;
        node[2 * half_leaves - 1] = before + left;
    }
}

__kernel void rsh_reduce_blelloch_scatter(RSH_STREAM, __global const uint* sums,
                                          __global uint* output)
{
    const strided_range mine = my_elements(RSH_LENGTH);
    for (uint i = mine.begin; i < mine.end; i += mine.step)
        if (is_kept(input, flags, i)) store_element(load_element(i, input), sums[i], output);
}
