/* rows.h - what lies at RSH_WIDTH places of a buffer, a few floats side by side at each, as rows: one
 * lane for each place. Loaded whole and transposed in registers: lane by lane, each row would go
 * through memory, where many small stores hold up the load of a vector.
 */
#ifndef RSH_LANES_ROWS_H
#define RSH_LANES_ROWS_H

#include "lanes/lanes.h"

#if RSH_WIDTH > 1
/* Every other element of two vectors, and two vectors from these. */
#define RSH_EVEN(a, b) ((floatv)((a).even, (b).even))
#define RSH_ODD(a, b) ((floatv)((a).odd, (b).odd))

/* Four vectors, of points with four components one after another, to a row for each component:
 * each step halves the components that a vector holds. */
static void points_to_rows(const floatv* points, floatv* row)
{
    for (uint c = 0; c < 2; ++c) {
        const floatv a = c ? RSH_ODD(points[0], points[1]) : RSH_EVEN(points[0], points[1]);
        const floatv b = c ? RSH_ODD(points[2], points[3]) : RSH_EVEN(points[2], points[3]);
        row[c] = RSH_EVEN(a, b);
        row[c + 2] = RSH_ODD(a, b);
    }
}

static floatv side_by_side(floatv even, floatv odd, bool is_upper)
{
    floatv both;
    both.even = is_upper ? even.hi : even.lo;
    both.odd = is_upper ? odd.hi : odd.lo;
    return both;
}

static void rows_to_points(const floatv* row, floatv* points)
{
    for (uint i = 0; i < 2; ++i) {
        const floatv a = side_by_side(row[0], row[2], i), b = side_by_side(row[1], row[3], i);
        points[2 * i] = side_by_side(a, b, false);
        points[2 * i + 1] = side_by_side(a, b, true);
    }
}

#if RSH_WIDTH == 16
#define RSH_POINTS(at, k) ((floatv)(at(k), at((k) + 1), at((k) + 2), at((k) + 3)))
#define RSH_STORE_POINTS(store, v, k)                                       \
    store((v).lo.lo, k) store((v).lo.hi, (k) + 1) store((v).hi.lo, (k) + 2) \
        store((v).hi.hi, (k) + 3)
#elif RSH_WIDTH == 8
#define RSH_POINTS(at, k) ((floatv)(at(k), at((k) + 1)))
#define RSH_STORE_POINTS(store, v, k) store((v).lo, k) store((v).hi, (k) + 1)
#else
#define RSH_POINTS(at, k) (at(k))
#define RSH_STORE_POINTS(store, v, k) store(v, k)
#endif
#endif

/* Four floats of each lane, from base[stride * index] on: row[0 .. 3]. */
static void load_rows4(__global const float* base, uint stride, const uint* index, floatv* row)
{
#define RSH_AT(k) vload4(0, base + (ulong)stride * index[k])
#if RSH_WIDTH == 1
    const float4 point = RSH_AT(0);
    row[0] = point.x, row[1] = point.y, row[2] = point.z, row[3] = point.w;
#else
    floatv points[4];
    for (uint i = 0; i < 4; ++i) points[i] = RSH_POINTS(RSH_AT, RSH_WIDTH / 4 * i);
    points_to_rows(points, row);
#endif
#undef RSH_AT
}

/* Three floats of each lane: row[0 .. 2]. */
static void load_rows3(__global const float* base, uint stride, const uint* index, floatv* row)
{
#define RSH_AT(k) ((float4)(vload3(0, base + (ulong)stride * index[k]), 0.0f))
#if RSH_WIDTH == 1
    const float4 point = RSH_AT(0);
    row[0] = point.x, row[1] = point.y, row[2] = point.z;
#else
    floatv points[4], all[4];
    for (uint i = 0; i < 4; ++i) points[i] = RSH_POINTS(RSH_AT, RSH_WIDTH / 4 * i);
    points_to_rows(points, all);
    for (uint c = 0; c < 3; ++c) row[c] = all[c];
#endif
#undef RSH_AT
}

/* Of the lanes in `bits`, row[0 .. 3] to base[stride * index]. */
static void store_rows4(const floatv* row, uint bits, __global float* base, uint stride,
                        const uint* index)
{
#define RSH_STORE(point, k) \
    if (bits >> (k)&1) vstore4(point, 0, base + (ulong)stride * index[k]);
#if RSH_WIDTH == 1
    RSH_STORE((float4)(row[0], row[1], row[2], row[3]), 0)
#else
    floatv points[4];
    rows_to_points(row, points);
    RSH_STORE_POINTS(RSH_STORE, points[0], 0)
    RSH_STORE_POINTS(RSH_STORE, points[1], RSH_WIDTH / 4)
    RSH_STORE_POINTS(RSH_STORE, points[2], RSH_WIDTH / 2)
    RSH_STORE_POINTS(RSH_STORE, points[3], 3 * RSH_WIDTH / 4)
#endif
#undef RSH_STORE
}

#endif
