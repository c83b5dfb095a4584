/* closest_hit_atomic.h - intersects (triangle, ray) pairs and keeps what they hit, whatever
 * order they come in.
 *
 * While a traversal runs, hits[ray].primitive is the best triangle so far. An offer replaces it
 * by compare-and-swap only if the new hit is closer, or as close with a lower index; the t of
 * the old one is computed again, by the same instructions, so 32-bit atomics suffice, and t, u
 * and v need not be stored until rsh_resolve. The order of offers cannot matter: the result is
 * a minimum. With RSH_ALL_HITS each hit is counted, and listed as traverse/hit_list.h says.
 */
#ifndef RSH_TRAVERSE_PAPER_FAITHFUL_CLOSEST_HIT_ATOMIC_H
#define RSH_TRAVERSE_PAPER_FAITHFUL_CLOSEST_HIT_ATOMIC_H

#include "mesh/leaving.h"
#include "traverse/hit_list.h"
#include "traverse/paper_faithful/types.h"

typedef struct hit_target {
    triangles_left left;
    volatile __global rsh_hit* hits;
    volatile __global uint* occlusion;
    uint occlusion_bit; /* as a mask; 0: closest hits are wanted */
    hit_list* list;     /* see traverse/hit_list.h */
} hit_target;

#if RSH_ALL_HITS

static void offer_hit(const hit_target* target, uint ray, rsh_hit hit)
{
    add_to_list(target->list, ray, atomic_inc(target->occlusion + ray), hit);
}

#else

static bool is_closer(const hit_target* target, uint ray, float t, uint triangle, uint best)
{
    triangle_points corners;
    rsh_hit hit;
    load_triangle(target->left.mesh, target->left.vertices, target->left.indices, best,
                  &corners);
    intersect_one(target->left.rays[ray], corners, &hit);
    return t < hit.t || (t == hit.t && triangle < best);
}

static void offer_hit(const hit_target* target, uint ray, rsh_hit hit)
{
    if (target->occlusion_bit) {
        atomic_or(target->occlusion + ray, target->occlusion_bit);
        return;
    }
    volatile __global uint* slot = &target->hits[ray].primitive;
    uint best = RSH_NO_HIT; /* a guess: the first exchange reads the slot */
    do {
        const uint seen = atomic_cmpxchg(slot, best, hit.primitive);
        if (seen == best) return;
        best = seen;
    } while (is_closer(target, ray, hit.t, hit.primitive, best));
}

#endif

/* Lane i gets ray and triangle of pair i; lanes from `count` on repeat pair 0. Returns the places of
 * the corners. */
static uintv gather_pairs(const hit_target* target, const stream_pair* pairs, uint count,
                          sheared_rays* sheared, floatv* corner)
{
    float lanes[17][RSH_WIDTH];
    for (uint i = 0; i < RSH_WIDTH; ++i) {
        const stream_pair pair = pairs[i < count ? i : 0];
        const rsh_ray ray = target->left.rays[pair.node];
        triangle_points p;
        load_triangle(target->left.mesh, target->left.vertices, target->left.indices,
                      pair.triangle, &p);
        const float16 values =
            (float16)(ray.origin_tmin, ray.direction_tmax, p.v0, p.v1, p.v2.x, p.v2.y);
        float row[16];
        vstore16(values, 0, row);
        for (uint f = 0; f < 16; ++f) lanes[f][i] = row[f];
        lanes[16][i] = p.v2.z;
    }
    *sheared = shear_rays(load_lanes(lanes[0]), load_lanes(lanes[1]), load_lanes(lanes[2]),
                          load_lanes(lanes[4]), load_lanes(lanes[5]), load_lanes(lanes[6]),
                          load_lanes(lanes[3]), load_lanes(lanes[7]));
    for (uint f = 0; f < 9; ++f) corner[f] = load_lanes(lanes[8 + f]);
    return put_lanes_in_order(corner);
}

/* The weights of the corners at these places, a place per lane. */
static floatv weight_at(const lane_hits* hits, uintv place)
{
    return select(select(hits->weight[2], hits->weight[1], as_intv(place == (uintv)(1u))),
                  hits->weight[0], as_intv(place == (uintv)(0u)));
}

/* Whether mesh/leaving.h says that a pair's hit is none. */
static bool is_pair_left(const triangles_left* left, stream_pair pair, float t, float inverse_z)
{
    const uint skip = triangle_left_by(left, pair.node);
    if (skip == pair.triangle) return true;
    if (skip == RSH_NO_HIT) return false;
    triangle_points corners;
    load_triangle(left->mesh, left->vertices, left->indices, pair.triangle, &corners);
    put_in_order(&corners);
    return t <= RSH_DOUBTFUL_DEPTH * triangle_extent(corners) * inverse_z &&
           is_separated(left, pair.node, corners);
}

#if RSH_FILTER
/* Which rays see the corners of their triangle clockwise, a bit each; places: of these corners. */
static uint lanes_clockwise(const lane_hits* hits, floatv inverse_z, uintv places)
{
    const uint negative = RSH_LANE_BITS(hits->is_negative),
               backward = RSH_LANE_BITS(inverse_z < (floatv)(0.0f));
    uint clockwise = 0;
    for (uint k = 0; k < RSH_WIDTH; ++k)
        if (is_seen_clockwise(negative >> k & 1, backward >> k & 1, ((const uint*)&places)[k]))
            clockwise |= 1u << k;
    return clockwise;
}
#endif

/* Intersects up to RSH_WIDTH pairs. */
static void intersect_pairs(const hit_target* target, const stream_pair* pairs, uint count)
{
    sheared_rays sheared;
    floatv corner[9];
    const uintv places = gather_pairs(target, pairs, count, &sheared, corner);
    const lane_hits hits = RSH_FIND_HITS(sheared, corner);
    if (!any_lane(hits.is_hit)) return;
    int is_hit[RSH_WIDTH];
    float t[RSH_WIDTH], u[RSH_WIDTH], v[RSH_WIDTH], inverse_z[RSH_WIDTH];
    store_lanes(hits.is_hit, is_hit);
    store_lanes(hits.t, t);
    store_lanes(weight_at(&hits, places & 3u), u);
    store_lanes(weight_at(&hits, places >> 2), v);
    store_lanes(fabs(sheared.inverse_z), inverse_z);
    const triangles_left* left = &target->left;
#if RSH_FILTER
    const uint clockwise = lanes_clockwise(&hits, sheared.inverse_z, places);
    for (uint i = 0; i < count; ++i)
        is_hit[i] = is_hit[i] && !is_unseen(&left->filter, pairs[i].node, pairs[i].triangle,
                                            clockwise >> i & 1);
#endif
    for (uint i = 0; i < count; ++i)
        if (is_hit[i] && !(left->skip && is_pair_left(left, pairs[i], t[i], inverse_z[i])))
            offer_hit(target, pairs[i].node, (rsh_hit){t[i], u[i], v[i], pairs[i].triangle});
}

#endif
