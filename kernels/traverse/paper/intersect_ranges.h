/* intersect_ranges.h - the rays of a block against the triangles of a range, one triangle after
 * the other; see traverse/paper/intersect_ranges.cl. Goes on from the hits that earlier batches
 * found.
 */
#ifndef RSH_TRAVERSE_PAPER_INTERSECT_RANGES_H
#define RSH_TRAVERSE_PAPER_INTERSECT_RANGES_H

#include "traverse/continue_packet.h"

typedef struct range_target {
    triangles_left left;
    __global rsh_hit* hits;
    __global uint* occlusion;
    uint occlusion_bit;           /* as a mask; 0: closest hits are wanted */
    __global const float* bounds; /* the scene's BVH; ranges name places in its leaves */
    hit_list* list;               /* see traverse/hit_list.h */
} range_target;

#if RSH_ALL_HITS
static void load_target_hits(const range_target* target, const ray_tile* tile, uint b,
                             ray_packet* packet)
{
    packet->rows = 0;
    packet->list = target->list;
    for (uint k = 0; k < 16; ++k) {
        const uint i = ray_of(*tile, b, k);
        if (i != RSH_NO_RAY) ((uint*)packet->count)[k] = target->occlusion[i];
    }
}

static void store_target_packet(const range_target* target, ray_tile tile, uint b,
                                const ray_packet* packet)
{
    store_packet_counts(packet, tile, b, target->occlusion);
}
#else
static void load_target_hits(const range_target* target, const ray_tile* tile, uint b,
                             ray_packet* packet)
{
    (void)tile, (void)b;
    if (!target->occlusion_bit) continue_packet(packet, &target->left, target->hits);
}

static void store_target_packet(const range_target* target, ray_tile tile, uint b,
                                const ray_packet* packet)
{
    if (target->occlusion_bit)
        store_packet_occlusion(packet, tile, b, target->occlusion, target->occlusion_bit);
    else
        store_continued_hits(packet, &target->left, target->hits);
}
#endif

static void load_target_packet(const range_target* target, const ray_tile* tile, uint b,
                               ray_packet* packet)
{
    load_packet(packet, tile, b, &target->left, FLT_MAX);
    load_target_hits(target, tile, b, packet);
}

/* True if the hits of a ray have changed. */
static bool offer_triangle(const range_target* target, ray_packet* packet, uint place)
{
    __global const float* leaf = target->bounds + leaf_at(place / 16);
    if (as_uint(leaf[RSH_TRIANGLES_AT + place % 16]) == RSH_NO_HIT) return false;
    const leaf_triangle triangle = leaf_triangle_at(leaf, place % 16, true);
    return intersect_packet(packet, &triangle, target->occlusion_bit != 0);
}

#endif
