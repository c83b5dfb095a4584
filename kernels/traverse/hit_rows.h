/* hit_rows.h - the first hits of a vector of rays, a lane each, in rows: what a triangle adds for all of
 * them is stored at once, and rows are sorted with all rays side by side. A ray may leave lanes of rows
 * empty. Hits of a ray behind the first RSH_HIT_ROWS are records (traverse/hit_list.h).
 */
#ifndef RSH_TRAVERSE_HIT_ROWS_H
#define RSH_TRAVERSE_HIT_ROWS_H

#include "lanes/rows.h"
#include "traverse/types.h"

#if RSH_ALL_HITS

/* A hit in each lane. */
typedef struct hit_row {
    floatv t; /* INFINITY: the lane is empty */
    floatv u, v;
    uintv primitive;
} hit_row;

typedef struct hit_rows {
    hit_row row[RSH_HIT_ROWS];
    uint used;  /* rows, at least one */
    uint taken; /* lanes of the last of them, a bit each: all others are empty */
} hit_rows;

static void clear_rows(hit_rows* rows)
{
    rows->row[0].t = (floatv)(INFINITY);
    rows->used = 1;
    rows->taken = 0;
}

static uint taken_lanes(const hit_row* row)
{
    return RSH_LANE_BITS(row->t < (floatv)(INFINITY));
}

/* Puts the hits of two rows in their order, that of traverse/hit_order.h. True if some were not. */
static bool order_rows(hit_row* a, hit_row* b)
{
    const hit_row before = *a, after = *b;
    const intv is_swapped =
        (after.t < before.t) | ((after.t == before.t) & (after.t < (floatv)(INFINITY)) &
                                (after.primitive < before.primitive));
    if (!any_lane(is_swapped)) return false;
    a->t = select(before.t, after.t, is_swapped);
    a->u = select(before.u, after.u, is_swapped);
    a->v = select(before.v, after.v, is_swapped);
    a->primitive = select(before.primitive, after.primitive, as_uintv(is_swapped));
    b->t = select(after.t, before.t, is_swapped);
    b->u = select(after.u, before.u, is_swapped);
    b->v = select(after.v, before.v, is_swapped);
    b->primitive = select(after.primitive, before.primitive, as_uintv(is_swapped));
    return true;
}

/* Each ray's hits come in their order then, and empty lanes behind them. */
static void sort_rows(hit_rows* rows)
{
    for (uint i = 1; i < rows->used; ++i)
        for (uint at = i; at > 0 && order_rows(&rows->row[at - 1], &rows->row[at]); --at) {
        }
}

/* Adds a hit to lane k of the first row where it is empty. False: of none. */
static bool add_to_lane(hit_rows* rows, uint k, rsh_hit hit)
{
    uint at = 0;
    while (at < rows->used && ((const float*)&rows->row[at].t)[k] < INFINITY) ++at;
    if (at == RSH_HIT_ROWS) return false;
    hit_row* row = &rows->row[at];
    if (at == rows->used) {
        row->t = (floatv)(INFINITY);
        ++rows->used;
        rows->taken = 0;
    }
    if (at + 1 == rows->used) rows->taken |= 1u << k;
    ((float*)&row->t)[k] = hit.t;
    ((float*)&row->u)[k] = hit.u;
    ((float*)&row->v)[k] = hit.v;
    ((uint*)&row->primitive)[k] = hit.primitive;
    return true;
}

static rsh_hit hit_of_lane(const hit_row* row, uint k)
{
    return (rsh_hit){((const float*)&row->t)[k], ((const float*)&row->u)[k],
                     ((const float*)&row->v)[k], ((const uint*)&row->primitive)[k]};
}

/* The hits of some lanes, a bit each, one by one. Returns the lanes that there is no room for. */
RSH_CALLED static uint add_to_lanes(hit_rows* rows, const hit_row* hits, uint met)
{
    uint left = 0;
    for (; met; met &= met - 1) {
        const uint k = 31 - clz(met & -met);
        if (!add_to_lane(rows, k, hit_of_lane(hits, k))) left |= 1u << k;
    }
    return left;
}

/* Adds the hits in some lanes, a mask, and returns the lanes that there is no room for. is_taken: these
 * lanes and perhaps others, which stay empty; what is known before t is, so that the row is known early.
 * Whether there is a hit, and whether it needs a new row, is about as likely as not: no branches. */
static uint add_to_rows(hit_rows* rows, hit_row hits, intv is_hit, intv is_taken)
{
    const uint taken = RSH_LANE_BITS(is_taken);
    const bool is_next = (rows->taken & taken) != 0;
    if (rows->used == RSH_HIT_ROWS && is_next) {
        const hit_row copy = hits;
        return add_to_lanes(rows, &copy, RSH_LANE_BITS(is_hit));
    }
    rows->used += is_next;
    rows->taken = taken | (is_next ? 0 : rows->taken);
    hit_row* row = &rows->row[rows->used - 1];
    const floatv before = select(row->t, (floatv)(INFINITY), (intv)(is_next ? -1 : 0));
    row->t = select(before, hits.t, is_hit);
    row->u = select(row->u, hits.u, is_hit);
    row->v = select(row->v, hits.v, is_hit);
    row->primitive = select(row->primitive, hits.primitive, as_uintv(is_hit));
    return 0;
}

#endif

#endif
