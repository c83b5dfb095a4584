/* rows.h - what lies at RSH_WIDTH places of a buffer, a few floats side by side at each, as rows: one
 * lane for each place. Loaded whole and transposed in registers: lane by lane, each row would go
 * through memory, where many small stores hold up the load of a vector.
 */
#ifndef RSH_LANES_ROWS_H
#define RSH_LANES_ROWS_H

#include "lanes/sixteen.h"

#if RSH_WIDTH > 1
/* Of each four of a and b the lower two in turn, and the upper two: an instruction. RSH_FOURS: points
 * k, k + 4 and so on side by side; RSH_STORE_FOURS: takes them apart. */
#if RSH_WIDTH == 16
#define RSH_FOURS(at, k) ((floatv)(at(k), at((k) + 4), at((k) + 8), at((k) + 12)))
#define RSH_STORE_FOURS(store, v, k)                                        \
    store((v).lo.lo, k) store((v).lo.hi, (k) + 4) store((v).hi.lo, (k) + 8) \
        store((v).hi.hi, (k) + 12)
static floatv lower_lanes(floatv a, floatv b) { return lower_in_turn(a, b); }
static floatv upper_lanes(floatv a, floatv b) { return upper_in_turn(a, b); }
#elif RSH_WIDTH == 8
#define RSH_FOURS(at, k) ((floatv)(at(k), at((k) + 4)))
#define RSH_STORE_FOURS(store, v, k) store((v).lo, k) store((v).hi, (k) + 4)
static floatv lower_lanes(floatv a, floatv b)
{
    return (floatv)(a.s0, b.s0, a.s1, b.s1, a.s4, b.s4, a.s5, b.s5);
}
static floatv upper_lanes(floatv a, floatv b)
{
    return (floatv)(a.s2, b.s2, a.s3, b.s3, a.s6, b.s6, a.s7, b.s7);
}
#else
#define RSH_FOURS(at, k) (at(k))
#define RSH_STORE_FOURS(store, v, k) store(v, k)
static floatv lower_lanes(floatv a, floatv b) { return (floatv)(a.s0, b.s0, a.s1, b.s1); }
static floatv upper_lanes(floatv a, floatv b) { return (floatv)(a.s2, b.s2, a.s3, b.s3); }
#endif

/* Four vectors of RSH_FOURS, k from 0 to 3, to a row for each component of the points; done twice, all
 * is as it was. */
static void transpose_rows(floatv* row)
{
    const floatv a = lower_lanes(row[0], row[2]), b = lower_lanes(row[1], row[3]);
    const floatv c = upper_lanes(row[0], row[2]), d = upper_lanes(row[1], row[3]);
    row[0] = lower_lanes(a, b);
    row[1] = upper_lanes(a, b);
    row[2] = lower_lanes(c, d);
    row[3] = upper_lanes(c, d);
}
#endif

/* Four floats of each lane, from base[stride * index] on: row[0 .. 3]. */
RSH_CALLED static void load_rows4(__global const float* base, uint stride, const uint* index,
                                  floatv* row)
{
#define RSH_AT(k) vload4(0, base + (ulong)stride * index[k])
#if RSH_WIDTH == 1
    const float4 point = RSH_AT(0);
    row[0] = point.x, row[1] = point.y, row[2] = point.z, row[3] = point.w;
#else
    row[0] = RSH_FOURS(RSH_AT, 0);
    row[1] = RSH_FOURS(RSH_AT, 1);
    row[2] = RSH_FOURS(RSH_AT, 2);
    row[3] = RSH_FOURS(RSH_AT, 3);
    transpose_rows(row);
#endif
#undef RSH_AT
}

/* Three floats of each lane: row[0 .. 2]. */
RSH_CALLED static void load_rows3(__global const float* base, uint stride, const uint* index,
                                  floatv* row)
{
#define RSH_AT(k) ((float4)(vload3(0, base + (ulong)stride * index[k]), 0.0f))
#if RSH_WIDTH == 1
    const float4 point = RSH_AT(0);
    row[0] = point.x, row[1] = point.y, row[2] = point.z;
#else
    floatv all[4] = {RSH_FOURS(RSH_AT, 0), RSH_FOURS(RSH_AT, 1), RSH_FOURS(RSH_AT, 2),
                     RSH_FOURS(RSH_AT, 3)};
    transpose_rows(all);
    row[0] = all[0], row[1] = all[1], row[2] = all[2];
#endif
#undef RSH_AT
}

#define RSH_STORE_AT(point, k) \
    if (bits >> (k)&1) vstore4(point, 0, base + (ulong)stride * index[k]);
#if RSH_WIDTH == 1
#define RSH_STORE_ALL_ROWS(row) RSH_STORE_AT((float4)(row[0], row[1], row[2], row[3]), 0)
#else
#define RSH_STORE_ALL_ROWS(row)                          \
    floatv points[4] = {row[0], row[1], row[2], row[3]}; \
    transpose_rows(points);                              \
    RSH_STORE_FOURS(RSH_STORE_AT, points[0], 0)          \
    RSH_STORE_FOURS(RSH_STORE_AT, points[1], 1)          \
    RSH_STORE_FOURS(RSH_STORE_AT, points[2], 2)          \
    RSH_STORE_FOURS(RSH_STORE_AT, points[3], 3)
#endif
/* Defines a function that stores, of the lanes in `bits`, row[0 .. 3] to base[stride * index]. */
#define RSH_DEFINE_STORE_ROWS4(name, SPACE)                                                   \
    RSH_CALLED static void name(const floatv* row, uint bits, SPACE float* base, uint stride, \
                                const uint* index)                                            \
    {                                                                                         \
        RSH_STORE_ALL_ROWS(row)                                                               \
    }
RSH_DEFINE_STORE_ROWS4(store_rows4, __global)

/* Asks for the cache lines that a block's lanes, side by side from `index` on, will write. */
static void expect_rows(__global const float* base, uint stride, uint index)
{
    for (uint word = 0; RSH_WIDTH > 1 && word < RSH_WIDTH * stride; word += 16)
        RSH_EXPECT_STORE(base + (ulong)stride * index + word);
}

#endif
