/* sixteen.h - sixteen values side by side, in the RSH_VECTORS vectors that they fill. */
#ifndef RSH_LANES_SIXTEEN_H
#define RSH_LANES_SIXTEEN_H

#include "lanes/lanes.h"

#define RSH_VECTORS (16 / RSH_WIDTH)

/* A loop over them. Left alone, compilers for CPUs unroll it too late to keep arrays of vectors in
 * registers. */
#if RSH_WIDTH > 1
#define for_each_vector(v) _Pragma("unroll") for (uint v = 0; v < RSH_VECTORS; ++v)
#else
#define for_each_vector(v) for (uint v = 0; v < RSH_VECTORS; ++v)
#endif

/* The smaller and the larger of two; the second where the first is NaN. */
static floatv lesser(floatv a, floatv b) { return select(b, a, a < b); }
static floatv greater(floatv a, floatv b) { return select(b, a, a > b); }

#if RSH_WIDTH > 1
/* The sixteen as one vector, whatever the registers hold, and taken out of one. */
#if RSH_WIDTH == 16
#define RSH_JOINED(v) ((v)[0])
#define RSH_TAKE_APART(whole, v) ((v)[0] = (whole))
#elif RSH_WIDTH == 8
#define RSH_JOINED(v) ((v)[0], (v)[1])
#define RSH_TAKE_APART(whole, v) ((v)[0] = (whole).lo, (v)[1] = (whole).hi)
#else
#define RSH_JOINED(v) ((v)[0], (v)[1], (v)[2], (v)[3])
#define RSH_TAKE_APART(whole, v)                                             \
    ((v)[0] = (whole).lo.lo, (v)[1] = (whole).lo.hi, (v)[2] = (whole).hi.lo, \
     (v)[3] = (whole).hi.hi)
#endif
static float16 joined(const floatv* v) { return (float16)RSH_JOINED(v); }
static uint16 joined_uints(const uintv* v) { return (uint16)RSH_JOINED(v); }
static void take_apart(float16 whole, floatv* v) { RSH_TAKE_APART(whole, v); }
static void take_uints_apart(uint16 whole, uintv* v) { RSH_TAKE_APART(whole, v); }

/* Of each four of a and b the lower two in turn, and the upper two: an instruction. */
static float16 lower_in_turn(float16 a, float16 b)
{
    return (float16)(a.s0, b.s0, a.s1, b.s1, a.s4, b.s4, a.s5, b.s5, a.s8, b.s8, a.s9, b.s9,
                     a.sc, b.sc, a.sd, b.sd);
}

static float16 upper_in_turn(float16 a, float16 b)
{
    return (float16)(a.s2, b.s2, a.s3, b.s3, a.s6, b.s6, a.s7, b.s7, a.sa, b.sa, a.sb, b.sb,
                     a.se, b.se, a.sf, b.sf);
}

/* Four words each of sixteen elements. In: lanes 4 r to 4 r + 3 of row i are the words of element
 * 4 r + i. Out: lane k of row w is word w of element k. Done twice, all is as it was. */
static void transpose_fours(float16* row)
{
    const float16 a = lower_in_turn(row[0], row[2]), b = lower_in_turn(row[1], row[3]);
    const float16 c = upper_in_turn(row[0], row[2]), d = upper_in_turn(row[1], row[3]);
    row[0] = lower_in_turn(a, b);
    row[1] = upper_in_turn(a, b);
    row[2] = lower_in_turn(c, d);
    row[3] = upper_in_turn(c, d);
}
#endif

/* The smallest and the largest of 16 lanes, none of them NaN. */
#if RSH_WIDTH > 1
#define RSH_ACROSS_LANES(name, COMPARE)                 \
    static float name(const floatv* v)                  \
    {                                                   \
        const float16 all = joined(v);                  \
        const float8 a = all.lo, b = all.hi;            \
        const float8 of_8 = a COMPARE b ? a : b;        \
        const float4 c = of_8.lo, d = of_8.hi;          \
        const float4 of_4 = c COMPARE d ? c : d;        \
        const float2 e = of_4.lo, f = of_4.hi;          \
        const float2 of_2 = e COMPARE f ? e : f;        \
        return of_2.x COMPARE of_2.y ? of_2.x : of_2.y; \
    }
#else
#define RSH_ACROSS_LANES(name, COMPARE)                                       \
    static float name(const float* v)                                         \
    {                                                                         \
        float best = v[0];                                                    \
        for (uint i = 1; i < 16; ++i) best = v[i] COMPARE best ? v[i] : best; \
        return best;                                                          \
    }
#endif
RSH_ACROSS_LANES(smallest_lane, <)
RSH_ACROSS_LANES(largest_lane, >)

#endif
