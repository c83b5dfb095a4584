/* reduce_chunk.cl - stream reduction, one run of elements per work-item, no barrier. Stable.
 *   input, flags  in   the stream
 *   counts        scratch, one per work-item
 *   output        out  its kept elements, packed;  output_count[output_index]  out  how many
 * The fallback where local memory or barriers cannot be trusted.
 */
#include "reduce_element.h"

typedef struct rsh_run {
    uint begin, end;
} rsh_run;

static rsh_run run_of(uint item, uint items, uint length)
{
    const uint run = length / items + (length % items != 0);
    const uint begin = (uint)min((ulong)run * item, (ulong)length);
    return (rsh_run){begin, begin + min(run, length - begin)};
}

__kernel void rsh_reduce_chunk_count(__global const uint* input, __global const uchar* flags,
                                     __global const uint* input_count, uint has_input_count,
                                     uint count, __global uint* counts)
{
    const uint me = get_global_id(0);
    const rsh_run run =
        run_of(me, get_global_size(0), stream_length(input_count, has_input_count, count));
    uint kept = 0;
    for (uint i = run.begin; i < run.end; ++i) kept += is_kept(input, flags, i);
    counts[me] = kept;
}

/* Each element is stored where the next kept one belongs and overwritten unless it is kept: no
 * branch to mispredict. Stopping at `end` keeps the last store inside this work-item's part. */
__kernel void rsh_reduce_chunk_write(__global const uint* input, __global const uchar* flags,
                                     __global const uint* input_count, uint has_input_count,
                                     uint count, __global const uint* counts,
                                     __global uint* output, __global uint* output_count,
                                     uint output_index)
{
    const uint me = get_global_id(0);
    const rsh_run run =
        run_of(me, get_global_size(0), stream_length(input_count, has_input_count, count));
    uint at = 0;
    for (uint i = 0; i < me; ++i) at += counts[i];
    const uint end = at + counts[me];
    if (me == get_global_size(0) - 1) output_count[output_index] = end;
    for (uint i = run.begin; i < run.end && at < end; ++i) {
        store_element(load_element(i, input), at, output);
        at += is_kept(input, flags, i);
    }
}
