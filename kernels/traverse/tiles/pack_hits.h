/* pack_hits.h - the end of a tile whose rays' hits are listed: those in rows (traverse/hit_rows.h) are
 * sorted and packed, ray by ray, while they are in the cache. traverse/list_hits.cl moves them to their
 * places.
 */
#ifndef RSH_TRAVERSE_TILES_PACK_HITS_H
#define RSH_TRAVERSE_TILES_PACK_HITS_H

#include "traverse/copy_hits.h"
#include "traverse/tiles/state.h"

#if RSH_ALL_HITS

/* Of the rays of vector v. */
static uintv hits_in_rows(const ray_packet* packet, uint v)
{
    return min(packet->count[v], (uintv)(RSH_HIT_ROWS));
}

static uint hits_in_all_rows(const traversal_state* state)
{
    uintv sum[RSH_VECTORS];
    for_each_vector(v) sum[v] = (uintv)(0u);
    for (uint b = 0; b < 16; ++b)
        for_each_vector(v) {
            if (state->loaded >> b & 1) sum[v] += hits_in_rows(&state->packet[b], v);
        }
    uint count = 0;
    for (uint k = 0; k < 16; ++k) count += ((const uint*)sum)[k];
    return count;
}

RSH_DEFINE_STORE_ROWS4(store_rows4_here, )
RSH_DEFINE_COPY_HITS(copy_hits_from_here, )

/* Sorts and packs the hits in rows of a block; returns how many they are. */
static uint pack_block(const ray_packet* packet, uint capacity, __global rsh_hit* packed)
{
    float4 hits[16 * RSH_HIT_ROWS];
    uint at[16], count = 0;
    for_each_vector(v) store_whole_uint(, hits_in_rows(packet, v), at + RSH_WIDTH * v);
    for (uint k = 0; k < 16; ++k) {
        const uint before = count;
        count += at[k];
        at[k] = before;
    }
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        hit_rows* rows = &packet->rows[v];
        sort_rows(rows);
        for (uint i = 0; i < rows->used; ++i) {
            const hit_row row = rows->row[i];
            const floatv word[4] = {row.t, row.u, row.v, as_floatv(row.primitive)};
            store_rows4_here(word, taken_lanes(&row), (float*)(hits + i), 4,
                             at + RSH_WIDTH * v);
        }
    }
    copy_hits_from_here(hits, count, capacity, packed);
    return count;
}

/* tile: its number. Hits that there is no room for are left away: then there is none for all of them. */
RSH_CALLED static void pack_hits(traversal_state* state, uint tile)
{
    const hit_list* list = &state->list;
    const uint count = hits_in_all_rows(state);
    const uint before = count ? atomic_add(list->packed, count) : 0, end = before + count;
    *packed_end_of(list->records, list->capacity, tile) = end;
    if (end < before || end > list->capacity) return;
    __global rsh_hit* packed = packed_at(list->records, list->capacity, end);
    for (uint b = 0; b < 16; ++b)
        if (state->loaded >> b & 1)
            packed += pack_block(&state->packet[b], list->capacity, packed);
}

#endif

#endif
