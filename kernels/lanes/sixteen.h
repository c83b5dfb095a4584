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

/* The smallest and the largest of 16 lanes, none of them NaN. */
#if RSH_WIDTH == 16
#define RSH_ACROSS_LANES(name, COMPARE)                 \
    static float name(const floatv* v)                  \
    {                                                   \
        const float8 a = v[0].lo, b = v[0].hi;          \
        const float8 of_8 = a COMPARE b ? a : b;        \
        const float4 c = of_8.lo, d = of_8.hi;          \
        const float4 of_4 = c COMPARE d ? c : d;        \
        const float2 e = of_4.lo, f = of_4.hi;          \
        const float2 of_2 = e COMPARE f ? e : f;        \
        return of_2.x COMPARE of_2.y ? of_2.x : of_2.y; \
    }
#else
#define RSH_ACROSS_LANES(name, COMPARE)                                             \
    static float name(const floatv* v)                                              \
    {                                                                               \
        float lane[16];                                                             \
        for_each_vector(i) store_lanes(v[i], lane + RSH_WIDTH * i);                 \
        float best = lane[0];                                                       \
        for (uint i = 1; i < 16; ++i) best = lane[i] COMPARE best ? lane[i] : best; \
        return best;                                                                \
    }
#endif
RSH_ACROSS_LANES(smallest_lane, <)
RSH_ACROSS_LANES(largest_lane, >)

#endif
