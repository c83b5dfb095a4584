/* tile.h - what a work-group does with a tile of elements, RSH_PER_ITEM for each
 * work-item: ranks the kept ones by a prefix sum, scatters them.
 *   sums  local, one uint per work-item
 * Every barrier is reached by all work-items of a full group, the same number of times.
 */
#ifndef RSH_REDUCE_TILE_H
#define RSH_REDUCE_TILE_H

#include "reduce/range.h"
#include "reduce/scan.h"
#include "tuning.h"

typedef struct tile_rank {
    uint kept;   /* bit k: my element k is kept                            */
    uint before; /* kept elements of the tile in front of mine             */
    uint total;  /* kept elements of the tile                              */
} tile_rank;

static uint tile_size(void) { return RSH_PER_ITEM * (uint)get_local_size(0); }

static tile_rank rank_tile(__global const uint* input, __global const uchar* flags,
                           stream_range tile, __local uint* sums)
{
    tile_rank rank = {0, 0, 0};
    const uint first = tile.begin + RSH_PER_ITEM * (uint)get_local_id(0);
    for (uint k = 0; k < RSH_PER_ITEM; ++k)
        if (first + k < tile.end) rank.kept |= is_kept(input, flags, first + k) << k;
    rank.before = scan_group(popcount(rank.kept), sums) - popcount(rank.kept);
    rank.total = sums[get_local_size(0) - 1];
    barrier(CLK_LOCAL_MEM_FENCE);
    return rank;
}

/* The tile's kept elements go to output[at ...]. */
static void scatter_tile(__global const uint* input, stream_range tile, tile_rank rank,
                         __global uint* output, uint at)
{
    const uint first = tile.begin + RSH_PER_ITEM * (uint)get_local_id(0);
    at += rank.before;
    for (uint k = 0; k < RSH_PER_ITEM; ++k)
        if (rank.kept >> k & 1) {
            store_element(load_element(first + k, input), at, output);
            ++at;
        }
}

#endif
