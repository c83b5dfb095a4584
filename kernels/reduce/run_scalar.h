/* run_scalar.h - runs in plain OpenCL C; see reduce/run.h. */
#ifndef RSH_REDUCE_RUN_SCALAR_H
#define RSH_REDUCE_RUN_SCALAR_H

#include "reduce/run_range.h"

#ifndef RSH_HAS_COMPRESS

static uint kept_lanes(__global const uint* input, __global const uchar* flags, uint i)
{
    uint lanes = 0;
    for (uint k = 0; k < 16; ++k) lanes |= is_kept(input, flags, i + k) << k;
    return lanes;
}

static uint count_run(__global const uint* input, __global const uchar* flags, rsh_run run)
{
    uint kept = 0;
    for (uint i = run.begin; i < run.end; ++i) kept += is_kept(input, flags, i);
    return kept;
}

/* Each element is stored where the next kept one belongs and overwritten unless it is kept: no
 * branch to mispredict. A step moves `at` on by one at most, so eight steps from below
 * end - 7 store below `end`; the last ones look before they store. */
static void pack_run(__global const uint* input, __global const uchar* flags, rsh_run run,
                     uint kept, __global uint* output, uint at)
{
    const uint end = at + kept;
    uint i = run.begin;
    for (; i + 8 <= run.end && at + 8 <= end; i += 8)
        for (uint k = 0; k < 8; ++k) {
            store_element(load_element(i + k, input), at, output);
            at += is_kept(input, flags, i + k);
        }
    for (; i < run.end && at < end; ++i) {
        store_element(load_element(i, input), at, output);
        at += is_kept(input, flags, i);
    }
}

#endif
#endif
