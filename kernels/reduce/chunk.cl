/* chunk.cl - stream reduction, one range of elements per work-item, no barrier. Stable.
 *   input, flags  in   the stream
 *   counts        scratch, one per work-item
 *   output        out  its kept elements, packed;  output_count[output_index]  out  how many
 * The fallback where local memory or barriers cannot be trusted.
 */
#include "reduce/range.h"
#include "tuning.h"

__kernel void rsh_reduce_chunk_count(RSH_STREAM, __global uint* counts)
{
    const uint me = get_global_id(0);
    counts[me] = count_range(input, flags, item_range(me, get_global_size(0), RSH_LENGTH));
}

__kernel void rsh_reduce_chunk_write(RSH_STREAM, __global const uint* counts,
                                     __global uint* output, __global uint* output_count,
                                     uint output_index)
{
    const uint me = get_global_id(0), items = get_global_size(0);
    uint at = 0;
    for (uint i = 0; i < me; ++i) at += counts[i];
    if (me == items - 1) output_count[output_index] = at + counts[me];
    pack_range(input, flags, item_range(me, items, RSH_LENGTH), counts[me], output, at);
}

/* A short stream in one launch, by one work-item. */
__kernel void rsh_reduce_chunk_alone(RSH_STREAM, __global uint* output,
                                     __global uint* output_count, uint output_index)
{
    const uint length = RSH_LENGTH, ranges = ceil_divide(length, RSH_CACHED_RANGE);
    uint at = 0;
    for (uint p = 0; p < ranges; ++p) {
        const stream_range range = tile_range(p, RSH_CACHED_RANGE, length);
        const uint kept = count_range(input, flags, range);
        pack_range(input, flags, range, kept, output, at);
        at += kept;
    }
    output_count[output_index] = at;
}
