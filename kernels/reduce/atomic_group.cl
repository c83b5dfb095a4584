/* atomic_group.cl - stream reduction by an atomic counter that every tile, not every
 * element, takes its places from (aggregated atomics). Not stable: tiles come in any order,
 * their elements in that of the input.
 *   input, flags  in   the stream
 *   output        out  its kept elements
 *   output_count[output_index]  in/out  0, then how many
 * A tile is worked off by one work-item, or by a group.
 */
#include "reduce/tile.h"

__kernel void rsh_reduce_atomic_group_items(RSH_STREAM, uint tile, __global uint* output,
                                            volatile __global uint* output_count,
                                            uint output_index)
{
    const uint length = RSH_LENGTH, tiles = ceil_divide(length, tile);
    for (uint t = get_global_id(0); t < tiles; t += get_global_size(0)) {
        const stream_range range = tile_range(t, tile, length);
        const uint kept = count_range(input, flags, range);
        const uint at = atomic_add(output_count + output_index, kept);
        pack_range(input, flags, range, kept, output, at);
    }
}

/* All groups work off the same number of tiles. Behind the sums: where this one goes. */
__kernel void rsh_reduce_atomic_group(RSH_STREAM, __global uint* output,
                                      volatile __global uint* output_count, uint output_index,
                                      __local uint* sums)
{
    const uint length = RSH_LENGTH;
    const uint rounds = ceil_divide(ceil_divide(length, tile_size()), get_num_groups(0));
    __local uint* shared = sums + get_local_size(0);
    for (uint r = 0; r < rounds; ++r) {
        const uint index = r * get_num_groups(0) + get_group_id(0);
        const stream_range tile = tile_range(index, tile_size(), length);
        const tile_rank rank = rank_tile(input, flags, tile, sums);
        if (get_local_id(0) == 0) *shared = atomic_add(output_count + output_index, rank.total);
        barrier(CLK_LOCAL_MEM_FENCE);
        scatter_tile(input, tile, rank, output, *shared);
        barrier(CLK_LOCAL_MEM_FENCE);
    }
}
