/* scan_scatter.cl - stream reduction by prefix sums: count per work-group, scan the
 * counts (reduce/scan_counts.cl), then each group ranks its elements and scatters. Stable.
 *   input, flags  in   the stream
 *   counts        scratch, one per work-group, then where the group's output begins
 *   output        out  its kept elements, packed
 * All groups work off the same number of tiles, one behind the other.
 */
#include "reduce/tile.h"

static uint tiles_per_group(uint length)
{
    return ceil_divide(ceil_divide(length, tile_size()), get_num_groups(0));
}

__kernel void rsh_reduce_scan_scatter_count(RSH_STREAM, __global uint* counts,
                                            __local uint* sums)
{
    const uint length = RSH_LENGTH, tiles = tiles_per_group(length);
    uint kept = 0;
    for (uint t = 0; t < tiles; ++t) {
        const stream_range tile = tile_range(get_group_id(0) * tiles + t, tile_size(), length);
        for (uint i = tile.begin + get_local_id(0); i < tile.end; i += get_local_size(0))
            kept += is_kept(input, flags, i);
    }
    const uint inclusive = scan_group(kept, sums);
    if (get_local_id(0) == get_local_size(0) - 1) counts[get_group_id(0)] = inclusive;
}

__kernel void rsh_reduce_scan_scatter_write(RSH_STREAM, __global const uint* counts,
                                            __global uint* output, __local uint* sums)
{
    const uint length = RSH_LENGTH, tiles = tiles_per_group(length);
    uint at = counts[get_group_id(0)];
    for (uint t = 0; t < tiles; ++t) {
        const stream_range tile = tile_range(get_group_id(0) * tiles + t, tile_size(), length);
        const tile_rank rank = rank_tile(input, flags, tile, sums);
        scatter_tile(input, tile, rank, output, at);
        at += rank.total;
    }
}
