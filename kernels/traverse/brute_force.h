/* brute_force.h - some rays against every triangle, as the engine and the audit do it.
 * A work-item holds RSH_VECTORS_PER_ITEM vectors of rays while the triangles stream past.
 */
#ifndef RSH_TRAVERSE_BRUTE_FORCE_H
#define RSH_TRAVERSE_BRUTE_FORCE_H

#include "mesh/leaving.h"
#include "rays/types.h"
#include "traverse/hit_list.h"
#include "tuning.h"

#define RSH_RAYS_PER_ITEM (RSH_VECTORS_PER_ITEM * RSH_WIDTH)

/* The hits of a work-item's rays, each by the place of its ray. */
typedef struct item_hits {
    float t[RSH_RAYS_PER_ITEM], u[RSH_RAYS_PER_ITEM], v[RSH_RAYS_PER_ITEM];
    uint primitive[RSH_RAYS_PER_ITEM];
#if RSH_ALL_HITS
    uint count[RSH_RAYS_PER_ITEM]; /* in place of those above */
    ulong sum[RSH_RAYS_PER_ITEM];  /* of the digests of the hits */
#endif
} item_hits;

/* Lanes without a ray, and inactive rays, get an empty interval. */
static sheared_rays load_sheared_rays(__global const rsh_ray* rays, const uint* index)
{
    float lanes[8][RSH_WIDTH];
    for (uint i = 0; i < RSH_WIDTH; ++i) {
        const rsh_ray ray = rays[index[i] == RSH_NO_RAY ? 0 : index[i]];
        float row[8];
        vstore8((float8)(ray.origin_tmin, ray.direction_tmax), 0, row);
        for (uint f = 0; f < 8; ++f) lanes[f][i] = row[f];
        if (index[i] == RSH_NO_RAY || !is_active(ray)) lanes[7][i] = -1.0f;
    }
    return shear_rays(load_lanes(lanes[0]), load_lanes(lanes[1]), load_lanes(lanes[2]),
                      load_lanes(lanes[4]), load_lanes(lanes[5]), load_lanes(lanes[6]),
                      load_lanes(lanes[3]), load_lanes(lanes[7]));
}

/* Leaves out what mesh/leaving.h says is no hit. */
static void drop_left(const triangles_left* left, sheared_rays r, const uint* index,
                      uint triangle, triangle_points points, lane_hits* hits)
{
    const floatv limit =
        (floatv)(RSH_DOUBTFUL_DEPTH * triangle_extent(points)) * fabs(r.inverse_z);
    const uint doubtful = RSH_LANE_BITS(hits->t <= limit);
    uint hit = RSH_LANE_BITS(hits->is_hit), none = 0;
    for (; hit; hit &= hit - 1) {
        const uint k = 31 - clz(hit & -hit), skip = triangle_left_by(left, index[k]);
        if (skip == triangle ||
            (skip != RSH_NO_HIT && (doubtful >> k & 1) && is_separated(left, index[k], points)))
            none |= 1u << k;
    }
    hits->is_hit &= ~mask_of_bits(none);
}

#if RSH_FILTER
/* Leaves out what mesh/filter.h says is not seen. */
static void drop_unseen(const hit_filter* filter, sheared_rays r, const uint* index,
                        uint triangle, uint places, lane_hits* hits)
{
    const uint negative = RSH_LANE_BITS(hits->is_negative),
               backward = RSH_LANE_BITS(r.inverse_z < (floatv)(0.0f));
    uint hit = RSH_LANE_BITS(hits->is_hit), none = 0;
    for (; hit; hit &= hit - 1) {
        const uint k = 31 - clz(hit & -hit);
        if (is_unseen(filter, index[k], triangle,
                      is_seen_clockwise(negative >> k & 1, backward >> k & 1, places)))
            none |= 1u << k;
    }
    hits->is_hit &= ~mask_of_bits(none);
}
#endif

#if RSH_ALL_HITS

/* The hits of a vector of rays, as item_hits has them. */
typedef struct vector_hits {
    uint count[RSH_WIDTH];
    ulong sum[RSH_WIDTH];
} vector_hits;

/* A number that another hit hardly has (FNV-1a: Fowler, Noll, Vo): sums of it compare lists whose
 * order is not the same. */
static ulong digest_of(rsh_hit hit)
{
    const uint word[4] = {as_uint(hit.t), as_uint(hit.u), as_uint(hit.v), hit.primitive};
    ulong digest = 0xcbf29ce484222325ul;
    for (uint i = 0; i < 4; ++i) digest = (digest ^ word[i]) * 0x100000001b3ul;
    return digest;
}

static vector_hits no_vector_hits(void)
{
    vector_hits none;
    for (uint k = 0; k < RSH_WIDTH; ++k) none.count[k] = 0, none.sum[k] = 0;
    return none;
}

static void keep_hits(vector_hits* found, const lane_hits* hits, const uint* index,
                      uint triangle, uint places, hit_list* list)
{
    float t[RSH_WIDTH], u[RSH_WIDTH], v[RSH_WIDTH];
    store_lanes(hits->t, t);
    store_lanes(weight_of_corner(hits->weight, 1, places), u);
    store_lanes(weight_of_corner(hits->weight, 2, places), v);
    for (uint met = RSH_LANE_BITS(hits->is_hit); met; met &= met - 1) {
        const uint k = 31 - clz(met & -met);
        const rsh_hit hit = {t[k], u[k], v[k], triangle};
        found->sum[k] += digest_of(hit);
        add_to_list(list, index[k], found->count[k]++, hit);
    }
}

static void store_vector_hits(const vector_hits* found, uint first, item_hits* hits)
{
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        hits->count[first + k] = found->count[k];
        hits->sum[first + k] = found->sum[k];
    }
}

#else

typedef closest_hits vector_hits;

static vector_hits no_vector_hits(void) { return no_hits(); }

static void keep_hits(vector_hits* found, const lane_hits* hits, const uint* index,
                      uint triangle, uint places, hit_list* list)
{
    (void)index, (void)list; /* for all hits */
    keep_closer(found, *hits, triangle, places);
}

static void store_vector_hits(const vector_hits* found, uint first, item_hits* hits)
{
    store_lanes(found->t, hits->t + first);
    store_lanes(found->u, hits->u + first);
    store_lanes(found->v, hits->v + first);
    store_lanes(found->primitive, hits->primitive + first);
}

#endif

/* The hits of a vector of rays, and now this triangle, whose corners are in order. */
static void offer(const triangles_left* left, sheared_rays r, const uint* index, uint triangle,
                  triangle_points points, uint places, vector_hits* found, hit_list* list)
{
    floatv corner[9];
    broadcast_triangle(points, corner);
    lane_hits hits = RSH_FIND_HITS(r, corner);
    if (!any_lane(hits.is_hit)) return;
#if RSH_FILTER
    drop_unseen(&left->filter, r, index, triangle, places, &hits);
#endif
    if (left->skip) drop_left(left, r, index, triangle, points, &hits);
    keep_hits(found, &hits, index, triangle, places, list);
}

/* index: of RSH_RAYS_PER_ITEM rays. */
static void trace_by_force(const triangles_left* left, const uint* index, hit_list* list,
                           item_hits* hits)
{
    sheared_rays sheared[RSH_VECTORS_PER_ITEM];
    vector_hits found[RSH_VECTORS_PER_ITEM];
    for (int b = 0; b < RSH_VECTORS_PER_ITEM; ++b) {
        sheared[b] = load_sheared_rays(left->rays, index + b * RSH_WIDTH);
        found[b] = no_vector_hits();
    }
    for (uint i = 0; i < left->mesh.triangle_count; ++i) {
        triangle_points p;
        if (!load_triangle(left->mesh, left->vertices, left->indices, i, &p)) continue;
        const uint places = put_in_order(&p);
        for (int b = 0; b < RSH_VECTORS_PER_ITEM; ++b)
            offer(left, sheared[b], index + b * RSH_WIDTH, i, p, places, &found[b], list);
    }
    for (int b = 0; b < RSH_VECTORS_PER_ITEM; ++b)
        store_vector_hits(&found[b], b * RSH_WIDTH, hits);
}

/* The answer of the ray at place i. */
static rsh_hit hit_at(const item_hits* hits, uint i, rsh_ray ray)
{
    if (hits->primitive[i] == RSH_NO_HIT)
        return (rsh_hit){ray.direction_tmax.w, 0.0f, 0.0f, RSH_NO_HIT};
    return (rsh_hit){hits->t[i], hits->u[i], hits->v[i], hits->primitive[i]};
}

#endif
