/* stream_range.h - which elements a work-item's range holds, and how it may pack them. */
#ifndef RSH_REDUCE_STREAM_RANGE_H
#define RSH_REDUCE_STREAM_RANGE_H

#include "reduce/element.h"
#include "tuning.h"

typedef struct stream_range {
    uint begin, end;
    uint length; /* of the whole stream */
} stream_range;

static uint ceil_divide(uint length, uint tile) { return length / tile + (length % tile != 0); }

static stream_range tile_range(uint index, uint tile, uint length)
{
    const uint begin = (uint)min((ulong)index * tile, (ulong)length);
    return (stream_range){begin, begin + min(tile, length - begin), length};
}

/* One of `items` ranges of about the same length. */
static stream_range item_range(uint item, uint items, uint length)
{
    const uint steps = ceil_divide(length, RSH_RANGE_STEP);
    return tile_range(item, ceil_divide(steps, items) * RSH_RANGE_STEP, length);
}

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__BMI2__) && defined(__has_builtin)
#if __has_builtin(__builtin_ia32_compresssi512_mask) && __has_builtin(__builtin_ia32_pdep_di)
#define RSH_HAS_COMPRESS
#endif
#endif

#endif
