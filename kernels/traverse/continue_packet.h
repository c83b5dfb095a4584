/* continue_packet.h - a packet goes on from what its rays have hit before: in another batch, of the engine's
 * own or, in programs with RSH_BATCHES, of the scene. */
#ifndef RSH_TRAVERSE_CONTINUE_PACKET_H
#define RSH_TRAVERSE_CONTINUE_PACKET_H

#include "traverse/packet_hits.h"

#if !RSH_ALL_HITS

/* By what a triangle of this batch at the same t must be lower to replace the hit. */
static uint rank_of_hit(const triangles_left* left, uint primitive)
{
#if RSH_BATCHES
    return rank_in_batch(&left->batch, primitive);
#else
    (void)left;
    return primitive;
#endif
}

static void continue_packet(ray_packet* packet, const triangles_left* left,
                            __global const rsh_hit* hits)
{
    for (uint k = 0; k < 16; ++k) {
        const uint i = ray_of(*packet->tile, packet->b, k);
        if (i == RSH_NO_RAY || hits[i].primitive == RSH_NO_HIT) continue;
        const rsh_hit hit = hits[i];
        const uint v = k / RSH_WIDTH, lane = k % RSH_WIDTH;
        if (!(hit.t <= lane_of(&packet->ray[v].tmax, lane))) continue; /* none of this ray's */
        ((float*)&packet->ray[v].tmax)[lane] = hit.t;
        ((float*)&packet->u[v])[lane] = hit.u;
        ((float*)&packet->v[v])[lane] = hit.v;
        ((uint*)&packet->primitive[v])[lane] = rank_of_hit(left, hit.primitive);
    }
}

#if RSH_BATCHES

/* Writes the hits that have changed; all of them, misses too, if the batch is the first one. */
RSH_CALLED static void store_continued_hits(const ray_packet* packet,
                                            const triangles_left* left, __global rsh_hit* hits)
{
    const scene_batch* batch = &left->batch;
    for (uint k = 0; k < 16; ++k) {
        const uint i = ray_of(*packet->tile, packet->b, k), v = k / RSH_WIDTH;
        const uint found = ((const uint*)packet->primitive)[k];
        if (i == RSH_NO_RAY || (found == RSH_NO_HIT && batch->is_continued)) continue;
        if (found == RSH_NO_HIT) {
            hits[i] = (rsh_hit){lane_of(packet->given_tmax, k), 0.0f, 0.0f, RSH_NO_HIT};
            continue;
        }
        const float t = lane_of(&packet->ray[v].tmax, k % RSH_WIDTH);
        const rsh_hit before = hits[i];
        const bool is_kept = batch->is_continued && before.primitive != RSH_NO_HIT &&
                             before.t == t && rank_in_batch(batch, before.primitive) == found;
        if (!is_kept)
            hits[i] = (rsh_hit){t, lane_of(packet->u, k), lane_of(packet->v, k),
                                number_in_scene(batch, found)};
    }
}

/* Rays that are known to hit something are retired. */
static void retire_hidden(ray_packet* packet, __global const uint* occlusion, uint bit)
{
    for (uint k = 0; k < 16; ++k) {
        const uint i = ray_of(*packet->tile, packet->b, k);
        if (i != RSH_NO_RAY && (occlusion[i] & bit))
            ((float*)&packet->ray[k / RSH_WIDTH].tmax)[k % RSH_WIDTH] = -1.0f;
    }
}

#else

static void store_continued_hits(const ray_packet* packet, const triangles_left* left,
                                 __global rsh_hit* hits)
{
    (void)left;
    store_packet_hits(packet, *packet->tile, packet->b, hits);
}

#endif

#endif

#endif
