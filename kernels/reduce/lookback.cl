/* lookback.cl - stream reduction in one pass: a tile is counted, learns from the tiles
 * before it where its output begins, and is packed while it is still in the cache (Merrill and
 * Garland 2016). Stable.
 *   input, flags  in   the stream
 *   states        scratch, zero before: [0] the next tile; then two words per tile
 *   output        out  its kept elements, packed;  output_count[output_index]  out  how many
 *
 * OpenCL promises no progress between work-groups, so no tile relies on another one's: after
 * RSH_PATIENCE looks at a tile that says nothing, its elements are counted here (cf. Smith,
 * Levien and Owens, decoupled fallback, 2025). The answer is the same, whoever counts; only
 * time is lost. Each message is one word of its own, so no order between two of them matters:
 *   states[1 + 2 t]  1 + kept elements of tile t;      0: not known yet
 *   states[2 + 2 t]  1 + those of tiles 0 .. t;        0: not known yet
 */
#include "reduce/tile.h"
#include "tuning.h"

static uint read_state(volatile __global uint* word) { return atomic_add(word, 0); }

/* Kept elements in front of tile `index`. Every step either ends, goes one tile back, or runs
 * out of patience. */
static uint look_back(__global const uint* input, __global const uchar* flags, uint index,
                      uint tile, uint length, volatile __global uint* states)
{
    uint before = 0, looks = 0;
    for (uint t = index; t > 0;) {
        const uint through = read_state(states + 2 * (ulong)t);
        if (through > 0) return before + through - 1;
        uint alone = read_state(states + 2 * (ulong)t - 1);
        if (alone == 0 && ++looks > RSH_PATIENCE)
            alone = 1 + count_range(input, flags, tile_range(t - 1, tile, length));
        if (alone == 0) continue;
        before += alone - 1;
        looks = 0;
        --t;
    }
    return before;
}

/* Tells the others about this tile; returns where its output begins. */
static uint place_tile(__global const uint* input, __global const uchar* flags, uint index,
                       uint tile, uint length, uint kept, volatile __global uint* states)
{
    atomic_xchg(states + 2 * (ulong)index + 1, 1 + kept);
    const uint at = look_back(input, flags, index, tile, length, states);
    atomic_xchg(states + 2 * (ulong)index + 2, 1 + at + kept);
    return at;
}

/* A tile per work-item at a time, handed out in the order of the stream. */
__kernel void rsh_reduce_lookback_items(RSH_STREAM, uint tile, volatile __global uint* states,
                                        __global uint* output, __global uint* output_count,
                                        uint output_index)
{
    const uint length = RSH_LENGTH, tiles = max(1u, ceil_divide(length, tile));
    for (uint t = atomic_inc(states); t < tiles; t = atomic_inc(states)) {
        const stream_range range = tile_range(t, tile, length);
        const uint kept = count_range(input, flags, range);
        const uint at = place_tile(input, flags, t, tile, length, kept, states);
        pack_range(input, flags, range, kept, output, at);
        if (t == tiles - 1) output_count[output_index] = at + kept;
    }
}

/* A tile per group; as many groups as the longest stream has tiles. Behind the sums: the tile's
 * number and where its output begins. */
__kernel void rsh_reduce_lookback_group(RSH_STREAM, volatile __global uint* states,
                                        __global uint* output, __global uint* output_count,
                                        uint output_index, __local uint* sums)
{
    const uint length = RSH_LENGTH, tiles = max(1u, ceil_divide(length, tile_size()));
    __local uint* shared = sums + get_local_size(0);
    if (get_local_id(0) == 0) shared[0] = atomic_inc(states);
    barrier(CLK_LOCAL_MEM_FENCE);
    const uint index = shared[0];
    const stream_range tile = tile_range(index, tile_size(), length);
    const tile_rank rank = rank_tile(input, flags, tile, sums);
    if (get_local_id(0) == 0) {
        shared[1] = index < tiles ? place_tile(input, flags, index, tile_size(), length,
                                               rank.total, states)
                                  : 0;
        if (index == tiles - 1) output_count[output_index] = shared[1] + rank.total;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    scatter_tile(input, tile, rank, output, shared[1]);
}
