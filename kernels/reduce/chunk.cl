/* chunk.cl - stream reduction, one run of elements per work-item, no barrier. Stable.
 *   input, flags  in   the stream
 *   counts        scratch, one per work-item
 *   output        out  its kept elements, packed;  output_count[output_index]  out  how many
 * The fallback where local memory or barriers cannot be trusted.
 */
#include "reduce/run.h"

__kernel void rsh_reduce_chunk_count(RSH_STREAM, __global uint* counts)
{
    const uint me = get_global_id(0);
    counts[me] = count_run(input, flags, run_of(me, get_global_size(0), RSH_LENGTH));
}

__kernel void rsh_reduce_chunk_write(RSH_STREAM, __global const uint* counts,
                                     __global uint* output, __global uint* output_count,
                                     uint output_index)
{
    const uint me = get_global_id(0), items = get_global_size(0);
    uint at = 0;
    for (uint i = 0; i < me; ++i) at += counts[i];
    if (me == items - 1) output_count[output_index] = at + counts[me];
    pack_run(input, flags, run_of(me, items, RSH_LENGTH), counts[me], output, at);
}

/* Elements that are counted and then, still in the nearest cache, packed. */
#define RSH_PIECE 2048u

/* A short stream in one launch, by one work-item. */
__kernel void rsh_reduce_chunk_alone(RSH_STREAM, __global uint* output,
                                     __global uint* output_count, uint output_index)
{
    const uint length = RSH_LENGTH, pieces = tile_count(length, RSH_PIECE);
    uint at = 0;
    for (uint p = 0; p < pieces; ++p) {
        const rsh_run piece = tile_run(p, RSH_PIECE, length);
        const uint kept = count_run(input, flags, piece);
        pack_run(input, flags, piece, kept, output, at);
        at += kept;
    }
    output_count[output_index] = at;
}
