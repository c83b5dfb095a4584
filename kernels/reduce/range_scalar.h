/* range_scalar.h - ranges in plain OpenCL C; see reduce/range.h. */
#ifndef RSH_REDUCE_RANGE_SCALAR_H
#define RSH_REDUCE_RANGE_SCALAR_H

#include "reduce/stream_range.h"

#ifndef RSH_HAS_COMPRESS

static uint kept_lanes(__global const uint* input, __global const uchar* flags, uint i)
{
    uint lanes = 0;
    for (uint k = 0; k < 16; ++k) lanes |= is_kept(input, flags, i + k) << k;
    return lanes;
}

static uint count_range(__global const uint* input, __global const uchar* flags,
                        stream_range range)
{
    uint kept = 0;
    for (uint i = range.begin; i < range.end; ++i) kept += is_kept(input, flags, i);
    return kept;
}

/* Each element is stored where the next kept one belongs and overwritten unless it is kept: no
 * branch to mispredict. A step moves `at` on by one at most, so eight steps from below
 * end - 7 store below `end`; the last ones look before they store. */
static void pack_range(__global const uint* input, __global const uchar* flags,
                       stream_range range, uint kept, __global uint* output, uint at)
{
    const uint end = at + kept;
    uint i = range.begin;
    for (; i + 8 <= range.end && at + 8 <= end; i += 8)
        for (uint k = 0; k < 8; ++k) {
            store_element(load_element(i + k, input), at, output);
            at += is_kept(input, flags, i + k);
        }
    for (; i < range.end && at < end; ++i) {
        store_element(load_element(i, input), at, output);
        at += is_kept(input, flags, i);
    }
}

#endif
#endif
