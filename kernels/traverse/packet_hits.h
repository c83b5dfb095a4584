/* packet_hits.h - what a triangle changes in a packet: the closest hits of its rays, or, in a program
 * with RSH_ALL_HITS, the number of their hits and the lists of these. */
#ifndef RSH_TRAVERSE_PACKET_HITS_H
#define RSH_TRAVERSE_PACKET_HITS_H

#include "traverse/packet16.h"

#if RSH_FILTER
/* Hits with a triangle that the rays see, see mesh/filter.h. */
static intv without_unseen(const ray_packet* packet, uint v, const leaf_triangle* triangle,
                           const lane_hits* hits, intv is_hit)
{
    const uint negative = RSH_LANE_BITS(hits->is_negative),
               backward = RSH_LANE_BITS(packet->ray[v].inverse_z < (floatv)(0.0f));
    uint unseen = 0;
    for (uint hit = RSH_LANE_BITS(is_hit); hit; hit &= hit - 1) {
        const uint k = 31 - clz(hit & -hit);
        const uint ray = ray_of(*packet->tile, packet->b, RSH_WIDTH * v + k);
        if (is_unseen(
                packet->filter, ray, triangle->index,
                is_seen_clockwise(negative >> k & 1, backward >> k & 1, triangle->places)))
            unseen |= 1u << k;
    }
    return is_hit & ~mask_of_bits(unseen);
}
#endif

#if RSH_ALL_HITS

/* Makes records of the hits of vector v, those of the lanes whose bits are set. */
RSH_CALLED static void record_packet_hits(const ray_packet* packet, uint v, const hit_row* hits,
                                          uint met)
{
    for (; met; met &= met - 1) {
        const uint k = 31 - clz(met & -met);
        add_to_list(packet->list, ray_of(*packet->tile, packet->b, RSH_WIDTH * v + k),
                    ((const uint*)packet->count)[RSH_WIDTH * v + k], hit_of_lane(hits, k));
    }
}

static void list_packet_hits(ray_packet* packet, uint v, const leaf_triangle* triangle,
                             const lane_hits* hits)
{
    const hit_row row = {hits->t, weight_of_corner(hits->weight, 1, triangle->places),
                         weight_of_corner(hits->weight, 2, triangle->places),
                         (uintv)(triangle->index)};
    const uint left = packet->rows
                          ? add_to_rows(&packet->rows[v], row, hits->is_hit, hits->is_crossed)
                          : RSH_LANE_BITS(hits->is_hit);
    if (!left) return;
    const hit_row copy = row;
    record_packet_hits(packet, v, &copy, left);
}

/* True: a ray may have more hits now. Without branches, as every other triangle is hit. is_any: no hit
 * ends a ray. */
static bool intersect_packet(ray_packet* packet, const leaf_triangle* triangle, bool is_any)
{
    (void)is_any;
    for_each_vector(v) {
        const sheared_rays r = packet->ray[v];
        const ray_space_corners given = triangle_to_ray_space(r, packet->axis, triangle->at);
        ray_space_corners scaled = given;
        if (triangle->scale != 1.0f) scale_across(&scaled, (floatv)(triangle->scale));
        lane_hits hits = cross_unbranched(r, scaled, &given);
#if RSH_FILTER
        hits.is_hit = without_unseen(packet, v, triangle, &hits, hits.is_hit);
#endif
        if (packet->left)
            hits.is_hit =
                without_left(packet, v, triangle->at, triangle->index, hits.is_hit, hits.t);
        if (packet->list->records) list_packet_hits(packet, v, triangle, &hits);
        packet->count[v] += select((uintv)(0u), (uintv)(1u), as_uintv(hits.is_hit));
    }
    return true;
}

#else

/* True if a ray has a closer hit now. Of equal t the lower triangle stays, in whatever order
 * they come. is_any: a ray that hits something is retired. */
static bool intersect_packet(ray_packet* packet, const leaf_triangle* triangle, bool is_any)
{
    bool changed = false;
    for_each_vector(v) {
        const sheared_rays r = packet->ray[v];
        ray_space_corners sheared = triangle_to_ray_space(r, packet->axis, triangle->at);
        if (triangle->scale != 1.0f) scale_across(&sheared, (floatv)(triangle->scale));
        const lane_hits hits = intersect_sheared(r, sheared);
        intv is_better = hits.is_hit & ((hits.t < r.tmax) |
                                        ((uintv)(triangle->index) < packet->primitive[v]));
        if (!any_lane(is_better)) continue;
#if RSH_FILTER
        is_better = without_unseen(packet, v, triangle, &hits, is_better);
        if (!any_lane(is_better)) continue;
#endif
        if (packet->left) {
            is_better =
                without_left(packet, v, triangle->at, triangle->index, is_better, hits.t);
            if (!any_lane(is_better)) continue;
        }
        changed = true;
        packet->ray[v].tmax = select(r.tmax, is_any ? (floatv)(-1.0f) : hits.t, is_better);
        packet->u[v] =
            select(packet->u[v], weight_of_corner(hits.weight, 1, triangle->places), is_better);
        packet->v[v] =
            select(packet->v[v], weight_of_corner(hits.weight, 2, triangle->places), is_better);
        packet->primitive[v] =
            select(packet->primitive[v], (uintv)(triangle->index), as_uintv(is_better));
    }
    return changed;
}

#endif

#endif
