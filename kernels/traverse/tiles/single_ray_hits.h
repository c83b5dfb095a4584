/* single_ray_hits.h - what the triangles of a leaf change in a single ray; the same as
 * traverse/packet_hits.h for a packet.
 */
#ifndef RSH_TRAVERSE_TILES_SINGLE_RAY_HITS_H
#define RSH_TRAVERSE_TILES_SINGLE_RAY_HITS_H

#include "traverse/tiles/single_ray.h"

static sheared_rays sheared_ray_of(const single_ray* ray)
{
    sheared_rays r;
    r.inverse_z = (floatv)(ray->inverse_z);
    r.tmin = (floatv)(ray->tmin);
    r.tmax = (floatv)(ray->tmax);
    return r;
}

#if RSH_FILTER
/* Of the lanes whose bits are set, those whose triangles in vector v of a leaf the ray sees. */
static uint seen_lanes(const single_ray* ray, __global const float* leaf, uint v,
                       const lane_hits* hits, uint met)
{
    __global const uint* triangles = (__global const uint*)leaf + RSH_TRIANGLES_AT;
    const uint negative = RSH_LANE_BITS(hits->is_negative);
    uint seen = 0;
    for (; met; met &= met - 1) {
        const uint k = 31 - clz(met & -met), word = triangles[RSH_WIDTH * v + k];
        if (!is_unseen(ray->filter, ray->index, RSH_TRIANGLE_INDEX(word),
                       is_seen_clockwise(negative >> k & 1, ray->inverse_z < 0.0f,
                                         RSH_TRIANGLE_PLACES(word))))
            seen |= 1u << k;
    }
    return seen;
}
#endif

#if RSH_ALL_HITS

static void list_hit(single_ray* ray, rsh_hit hit)
{
    if (!add_to_lane(ray->rows, ray->lane, hit))
        add_to_list(ray->list, ray->index, ray->count, hit);
}

/* Counts and lists the hits with vector v of a leaf's triangles, those of the lanes whose bits are
 * set. */
static bool list_leaf_hits(single_ray* ray, __global const float* leaf, uint v,
                           const lane_hits* hits, uint met)
{
    __global const uint* triangles = (__global const uint*)leaf + RSH_TRIANGLES_AT;
    const uint before = ray->count;
    if (!ray->left && !ray->list->records) {
        ray->count += popcount(met);
        return true;
    }
    float t[RSH_WIDTH], weight[3][RSH_WIDTH];
    store_lanes(hits->t, t);
    for (uint i = 0; i < 3; ++i) store_lanes(hits->weight[i], weight[i]);
    for (; met; met &= met - 1) {
        const uint k = 31 - clz(met & -met), word = triangles[RSH_WIDTH * v + k];
        const uint triangle = RSH_TRIANGLE_INDEX(word), places = RSH_TRIANGLE_PLACES(word);
        if (ray->left && is_leaf_hit_left(ray, leaf, RSH_WIDTH * v + k, triangle, t[k]))
            continue;
        const rsh_hit hit = {t[k], weight[places & 3][k], weight[places >> 2][k], triangle};
        if (ray->list->records) list_hit(ray, hit);
        ++ray->count;
    }
    return ray->count != before;
}

/* True if the ray has more hits now. */
RSH_CALLED static bool intersect_leaf(single_ray* ray, __global const float* leaf,
                                      bool is_scaled, bool is_any)
{
    (void)is_any; /* no hit ends a ray */
    const sheared_rays r = sheared_ray_of(ray);
    bool changed = false;
    for_each_vector(v) {
        const ray_space_corners given = leaf_to_ray_space(ray, leaf, v);
        ray_space_corners scaled = given;
        if (is_scaled) scale_across(&scaled, scales_of(leaf, v));
        const lane_hits hits = cross_sheared(r, scaled, &given);
#if RSH_FILTER
        const uint met = seen_lanes(ray, leaf, v, &hits, RSH_LANE_BITS(hits.is_hit));
#else
        const uint met = RSH_LANE_BITS(hits.is_hit);
#endif
        if (met) changed |= list_leaf_hits(ray, leaf, v, &hits, met);
    }
    return changed;
}

#else

/* As intersect_packet: true if the ray has a closer hit now. */
RSH_CALLED static bool intersect_leaf(single_ray* ray, __global const float* leaf,
                                      bool is_scaled, bool is_any)
{
    __global const uint* triangles = (__global const uint*)leaf + RSH_TRIANGLES_AT;
    bool changed = false;
    for_each_vector(v) {
        ray_space_corners sheared = leaf_to_ray_space(ray, leaf, v);
        if (is_scaled) scale_across(&sheared, scales_of(leaf, v));
        const lane_hits hits = intersect_unbranched(sheared_ray_of(ray), sheared);
        uint met = RSH_LANE_BITS(hits.is_hit);
        if (!met) continue;
#if RSH_FILTER
        met = seen_lanes(ray, leaf, v, &hits, met);
        if (!met) continue;
#endif
        float t[RSH_WIDTH], weight[RSH_WIDTH];
        store_lanes(hits.t, t);
        uint closest = RSH_WIDTH, places = 0;
        for (; met; met &= met - 1) {
            const uint k = 31 - clz(met & -met), word = triangles[RSH_WIDTH * v + k];
            const uint triangle = RSH_TRIANGLE_INDEX(word);
            if (!(t[k] < ray->tmax || (t[k] == ray->tmax && triangle < ray->primitive)))
                continue;
            if (ray->left && is_leaf_hit_left(ray, leaf, RSH_WIDTH * v + k, triangle, t[k]))
                continue;
            closest = k;
            places = RSH_TRIANGLE_PLACES(word);
            ray->tmax = t[k];
            ray->primitive = triangle;
        }
        if (closest == RSH_WIDTH) continue;
        changed = true;
        store_lanes(weight_of_corner(hits.weight, 1, places), weight);
        ray->u = weight[closest];
        store_lanes(weight_of_corner(hits.weight, 2, places), weight);
        ray->v = weight[closest];
    }
    if (changed && is_any) ray->tmax = -1.0f;
    ray->limit = ray->tmax * RSH_RAISED;
    return changed;
}

#endif

#endif
