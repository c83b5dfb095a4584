/* run_range.h - which elements a work-item's run holds, and how it may pack them. */
#ifndef RSH_REDUCE_RUN_RANGE_H
#define RSH_REDUCE_RUN_RANGE_H

#include "reduce/element.h"

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

#endif
