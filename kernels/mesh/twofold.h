/* twofold.h - numbers and vectors held in two floats, high + low: about 46 bits on any device,
 * with or without double. Sums by Knuth's TwoSum, products by fma (Ogita, Rump and Oishi,
 * "Accurate sum and dot product", SIAM J. Sci. Comput. 26(6), 2005). Sizes far from 1 are the
 * caller's to scale: what underflows is lost.
 *
 * Errors, with u = 2^-24: what is dropped are products of two low parts and the roundings of
 * the low sums. In u^2 of the sum of its terms' sizes, a dot errs by 8 in the terms' low parts, 2
 * and 6 where these are added up, 5 where all is: 21; a component of a cross product by 7 in the
 * terms, 1, 3 and 4 in three sums, 4 where it is gathered: 19. 2^-42 is 64.
 */
#ifndef RSH_MESH_TWOFOLD_H
#define RSH_MESH_TWOFOLD_H

#include "mesh/algebra.h"

typedef struct twofold {
    float high, low;
} twofold;

typedef struct twofold3 {
    float3 high, low;
} twofold3;

static twofold3 twofold3_of(float3 v) { return (twofold3){v, (float3)(0.0f)}; }

/* a + b, exactly. */
static twofold exact_sum(float a, float b)
{
    const float sum = a + b;
    const float b_added = sum - a;
    return (twofold){sum, (a - (sum - b_added)) + (b - b_added)};
}

static twofold3 exact_sum3(float3 a, float3 b)
{
    const float3 sum = a + b;
    const float3 b_added = sum - a;
    return (twofold3){sum, (a - (sum - b_added)) + (b - b_added)};
}

/* The same number, with the larger part of it in `high`. */
static twofold3 gathered(float3 high, float3 low)
{
    const float3 sum = high + low;
    return (twofold3){sum, low - (sum - high)};
}

/* Component by component, exactly. */
static twofold3 exact_product3(float3 a, float3 b)
{
    const float3 product = a * b;
    return (twofold3){product, fma(a, b, -product)};
}

/* By a power of two. */
static twofold3 twofold_scaled(float scale, twofold3 v)
{
    return (twofold3){scale * v.high, scale * v.low};
}

static twofold twofold_dot(twofold3 a, twofold3 b)
{
    const twofold3 terms = exact_product3(a.high, b.high);
    const float3 low = terms.low + (a.high * b.low + a.low * b.high);
    const twofold two = exact_sum(terms.high.x, terms.high.y);
    const twofold three = exact_sum(two.high, terms.high.z);
    return exact_sum(three.high, (two.low + three.low) + (low.x + low.y + low.z));
}

static twofold3 twofold_cross(twofold3 a, twofold3 b)
{
    const twofold3 plus = exact_product3(a.high.yzx, b.high.zxy);
    const twofold3 minus = exact_product3(a.high.zxy, b.high.yzx);
    const twofold3 difference = exact_sum3(plus.high, -minus.high);
    const float3 low = (a.high.yzx * b.low.zxy + a.low.yzx * b.high.zxy) -
                       (a.high.zxy * b.low.yzx + a.low.zxy * b.high.yzx);
    return gathered(difference.high, difference.low + ((plus.low - minus.low) + low));
}

#endif
