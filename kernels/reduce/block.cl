/* block.cl - stream reduction by blocks (Roger, Assarsson, Holzschuch, GPGPU 2007):
 * blocks of fixed size are reduced on their own, the block counts are scanned
 * (reduce/scan_counts.cl), then each block's range is moved to its place. Stable.
 *   input, flags  in   the stream
 *   reduced       scratch, as long as the stream: block b's kept elements from b * block on
 *   counts        scratch, one per block, then where the block's range begins
 *   output        out  its kept elements, packed
 * Moving a range of known length to a known place is what the paper draws as a line segment: no
 * element is looked at again. Within a block: a work-item alone, or a group by prefix sum and
 * direct scatter, or, as where nothing could scatter, by prefix sum and dichotomic search.
 */
#include "reduce/tile.h"

__kernel void rsh_reduce_block_items(RSH_STREAM, uint block, uint blocks,
                                     __global uint* reduced, __global uint* counts)
{
    const uint length = RSH_LENGTH;
    for (uint b = get_global_id(0); b < blocks; b += get_global_size(0)) {
        const stream_range range = tile_range(b, block, length);
        counts[b] = count_range(input, flags, range);
        pack_range(input, flags, range, counts[b], reduced, range.begin);
    }
}

__kernel void rsh_reduce_block_scatter(RSH_STREAM, __global uint* reduced,
                                       __global uint* counts, __local uint* sums)
{
    const stream_range tile = tile_range(get_group_id(0), tile_size(), RSH_LENGTH);
    const tile_rank rank = rank_tile(input, flags, tile, sums);
    scatter_tile(input, tile, rank, reduced, tile.begin);
    if (get_local_id(0) == 0) counts[get_group_id(0)] = rank.total;
}

/* The work-item whose elements hold the tile's kept element number `wanted`: the first whose
 * inclusive sum is above it. */
static uint search_item(__local const uint* sums, uint wanted)
{
    uint low = 0, high = get_local_size(0) - 1;
    while (low < high) {
        const uint middle = (low + high) / 2;
        if (sums[middle] > wanted)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/* Each place of the output looks for its element; one per work-item, as in the paper. */
__kernel void rsh_reduce_block_search(RSH_STREAM, __global uint* reduced, __global uint* counts,
                                      __local uint* sums)
{
    const uint me = get_local_id(0), size = get_local_size(0);
    const stream_range tile = tile_range(get_group_id(0), size, RSH_LENGTH);
    const bool keeps = tile.begin + me < tile.end && is_kept(input, flags, tile.begin + me);
    scan_group(keeps, sums);
    const uint kept = sums[size - 1];
    if (me < kept) {
        const uint from = tile.begin + search_item(sums, me);
        store_element(load_element(from, input), tile.begin + me, reduced);
    }
    if (me == 0) counts[get_group_id(0)] = kept;
}

/* Ranges are moved by groups, word by word. */
__kernel void rsh_reduce_block_move(RSH_STREAM, uint block, uint blocks,
                                    __global const uint* reduced, __global const uint* places,
                                    __global const uint* output_count, uint output_index,
                                    __global uint* output)
{
    for (uint b = get_group_id(0); b < blocks; b += get_num_groups(0)) {
        const uint begin = places[b];
        const uint end = b + 1 < blocks ? places[b + 1] : output_count[output_index];
        __global const uint* from = reduced + (ulong)RSH_WORDS * b * block;
        __global uint* to = output + (ulong)RSH_WORDS * begin;
        const uint words = RSH_WORDS * (end - begin);
        for (uint w = get_local_id(0); w < words; w += get_local_size(0)) to[w] = from[w];
    }
}
