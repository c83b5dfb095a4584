/* count_emit.cl - the first half of a stream reduction that decides once: a bit per
 * element and a count per work-item. What is kept is emitted by reduce/chunk.cl, which reads
 * the bits as its flags. Stable; the counts are known before anything is written.
 *   input, flags  in   the stream
 *   bits          out  bit i % 8 of byte i / 8: element i is kept
 *   counts        out  one per work-item
 */
#include "reduce/range.h"

__kernel void rsh_reduce_count_emit_count(RSH_STREAM, __global uchar* bits,
                                          __global uint* counts)
{
    const uint me = get_global_id(0);
    const stream_range range = item_range(me, get_global_size(0), RSH_LENGTH);
    uint kept = 0, i = range.begin;
    for (; i + 16 <= range.end; i += 16) {
        const uint lanes = kept_lanes(input, flags, i);
        vstore2((uchar2)((uchar)lanes, (uchar)(lanes >> 8)), 0, bits + i / 8);
        kept += popcount(lanes);
    }
    for (; i < range.end; i += 8) {
        uint lanes = 0;
        for (uint k = 0; k < 8 && i + k < range.end; ++k)
            lanes |= is_kept(input, flags, i + k) << k;
        bits[i / 8] = (uchar)lanes;
        kept += popcount(lanes);
    }
    counts[me] = kept;
}
