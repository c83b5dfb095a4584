/* reduce_run.h - what one work-item does with a run of elements, whatever the strategy:
 *   kept_lanes  bit k: element i + k is kept; i + 15 must be in the stream, i a multiple of 16
 *   count_run   how many of the run are kept
 *   pack_run    stores the kept ones, `kept` as counted, at output[at ...]; touches no other
 *               element, so that work-items with neighbouring outputs do not disturb each other
 * Runs begin at multiples of RSH_RUN_STEP. With vector compress instructions in the device's
 * instruction set, and a compiler that lets them be named, sixteen elements go at a time.
 */
#ifndef RSH_REDUCE_RUN_H
#define RSH_REDUCE_RUN_H

#include "reduce_element.h"

#define RSH_RUN_STEP 64u

typedef struct rsh_run {
    uint begin, end;
    uint length; /* of the whole stream */
} rsh_run;

static uint tile_count(uint length, uint tile) { return length / tile + (length % tile != 0); }

static rsh_run tile_run(uint index, uint tile, uint length)
{
    const uint begin = (uint)min((ulong)index * tile, (ulong)length);
    return (rsh_run){begin, begin + min(tile, length - begin), length};
}

/* One of `items` runs of about the same length. */
static rsh_run run_of(uint item, uint items, uint length)
{
    const uint steps = tile_count(length, RSH_RUN_STEP);
    return tile_run(item, tile_count(steps, items) * RSH_RUN_STEP, length);
}

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__BMI2__) && defined(__has_builtin)
#if __has_builtin(__builtin_ia32_compresssi512_mask) && __has_builtin(__builtin_ia32_pdep_di)
#define RSH_HAS_COMPRESS
#endif
#endif

#ifdef RSH_HAS_COMPRESS
#include "reduce_run_compress.h"
#else
#include "reduce_run_scalar.h"
#endif

#endif
