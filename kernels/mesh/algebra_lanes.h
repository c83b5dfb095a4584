/* algebra_lanes.h - 3-vectors, RSH_WIDTH of them at once. What mesh/algebra.h and mesh/twofold.h do
 * with one vector is done here with each lane, operation by operation: the same bits.
 */
#ifndef RSH_MESH_ALGEBRA_LANES_H
#define RSH_MESH_ALGEBRA_LANES_H

#include "mesh/plane.h"

typedef struct float3v {
    floatv x, y, z;
} float3v;

/* High + low, as twofold and twofold3. */
typedef struct twofoldv {
    floatv high, low;
} twofoldv;
typedef struct twofold3v {
    float3v high, low;
} twofold3v;

/* The same vector in every lane. */
static float3v lanes_of(float3 v)
{
    return (float3v){(floatv)(v.x), (floatv)(v.y), (floatv)(v.z)};
}

static float3v sum_v(float3v a, float3v b)
{
    return (float3v){a.x + b.x, a.y + b.y, a.z + b.z};
}
static float3v minus_v(float3v a, float3v b)
{
    return (float3v){a.x - b.x, a.y - b.y, a.z - b.z};
}
static float3v product_v(float3v a, float3v b)
{
    return (float3v){a.x * b.x, a.y * b.y, a.z * b.z};
}
static float3v scaled_v(floatv s, float3v a) { return (float3v){s * a.x, s * a.y, s * a.z}; }
static float3v opposite_v(float3v a) { return (float3v){-a.x, -a.y, -a.z}; }
static float3v fabs_v(float3v a) { return (float3v){fabs(a.x), fabs(a.y), fabs(a.z)}; }
static float3v select_v(float3v a, float3v b, intv mask)
{
    return (float3v){select(a.x, b.x, mask), select(a.y, b.y, mask), select(a.z, b.z, mask)};
}

/* The barycentric point, as an offset from v0: an error of u or v moves it along the triangle only, and
 * the size of the coordinates counts once, where it is added to v0. */
static float3v barycentric_offset_v(float3v v0, float3v v1, float3v v2, floatv u, floatv v)
{
    return sum_v(scaled_v(u, minus_v(v1, v0)), scaled_v(v, minus_v(v2, v0)));
}

static floatv dot_v(float3v a, float3v b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static floatv largest_v(float3v v) { return fmax(v.x, fmax(v.y, v.z)); }

static intv is_finite_v(float3v v)
{
    const floatv infinite = (floatv)(INFINITY);
    return (fabs(v.x) < infinite) & (fabs(v.y) < infinite) & (fabs(v.z) < infinite);
}

static floatv scale_to_one_v(floatv size)
{
    const intv exponent =
        clamp(as_intv(size) & 0x7f800000, (intv)(0x00800000), (intv)(0x7e000000));
    return as_floatv(0x7f000000 - exponent);
}

/* a * b - c * d, as cross3. */
static floatv cross_component(floatv a, floatv b, floatv c, floatv d)
{
    const floatv product = c * d;
    const floatv error = fma(-c, d, product);
    return fma(a, b, -product) + error;
}

static float3v cross_v(float3v a, float3v b)
{
    return (float3v){cross_component(a.y, b.z, a.z, b.y), cross_component(a.z, b.x, a.x, b.z),
                     cross_component(a.x, b.y, a.y, b.x)};
}

static float3v unit_v(float3v v)
{
    const floatv size = largest_v(fabs_v(v));
    const float3v w = scaled_v(scale_to_one_v(size), v);
    const floatv length = sqrt(dot_v(w, w));
    const float3v unit = {w.x / length, w.y / length, w.z / length};
    return select_v(lanes_of((float3)(0.0f)), unit, is_finite_v(v) & (size > (floatv)(0.0f)));
}

static floatv safe_length_v(float3v v)
{
    const floatv scale = largest_v(fabs_v(v));
    const float3v w = {v.x / scale, v.y / scale, v.z / scale};
    const floatv length = scale * sqrt(w.x * w.x + w.y * w.y + w.z * w.z);
    return select((floatv)(INFINITY), select((floatv)(0.0f), length, scale > (floatv)(0.0f)),
                  is_finite_v(v));
}

static twofoldv exact_sum_v(floatv a, floatv b)
{
    const floatv sum = a + b;
    const floatv b_added = sum - a;
    return (twofoldv){sum, (a - (sum - b_added)) + (b - b_added)};
}

static twofold3v exact_sum3_v(float3v a, float3v b)
{
    const twofoldv x = exact_sum_v(a.x, b.x), y = exact_sum_v(a.y, b.y),
                   z = exact_sum_v(a.z, b.z);
    return (twofold3v){{x.high, y.high, z.high}, {x.low, y.low, z.low}};
}

static twofold3v gathered_v(float3v high, float3v low)
{
    const float3v sum = sum_v(high, low);
    return (twofold3v){sum, minus_v(low, minus_v(sum, high))};
}

static twofold3v exact_product3_v(float3v a, float3v b)
{
    const float3v p = product_v(a, b);
    return (twofold3v){p, {fma(a.x, b.x, -p.x), fma(a.y, b.y, -p.y), fma(a.z, b.z, -p.z)}};
}

static twofold3v twofold3_of_v(float3v v) { return (twofold3v){v, lanes_of((float3)(0.0f))}; }

static twofold3v twofold_scaled_v(floatv scale, twofold3v v)
{
    return (twofold3v){scaled_v(scale, v.high), scaled_v(scale, v.low)};
}

static twofold3v twofold_sum3_v(twofold3v a, twofold3v b)
{
    const twofold3v sum = exact_sum3_v(a.high, b.high);
    return gathered_v(sum.high, sum_v(sum.low, sum_v(a.low, b.low)));
}

static twofold3v twofold_times_v(twofoldv a, twofold3v v)
{
    const twofold3v product = exact_product3_v((float3v){a.high, a.high, a.high}, v.high);
    const float3v low = sum_v(scaled_v(a.high, v.low), scaled_v(a.low, v.high));
    return gathered_v(product.high, sum_v(product.low, low));
}

/* Not gathered: `high` is that of floats, `low` what it leaves. */
static twofoldv twofold_quotient_v(twofoldv a, twofoldv b)
{
    const floatv quotient = a.high / b.high;
    const floatv rest = fma(-quotient, b.high, a.high) + (a.low - quotient * b.low);
    return (twofoldv){quotient, rest / b.high};
}

/* Unit vectors, rounded once per component; 0 for vectors without a direction. */
static float3v twofold_unit_v(twofold3v v)
{
    const floatv size = largest_v(fabs_v(v.high));
    const twofold3v w = twofold_scaled_v(scale_to_one_v(size), v);
    const floatv inverse = (floatv)(1.0f) / sqrt(dot_v(w.high, w.high));
    const twofold3v unit = exact_product3_v(w.high, (float3v){inverse, inverse, inverse});
    const float3v rounded = sum_v(unit.high, sum_v(unit.low, scaled_v(inverse, w.low)));
    return select_v(lanes_of((float3)(0.0f)), rounded,
                    (size > (floatv)(0.0f)) & (size < (floatv)(INFINITY)));
}

static twofoldv twofold_dot_v(twofold3v a, twofold3v b)
{
    const twofold3v terms = exact_product3_v(a.high, b.high);
    const float3v low =
        sum_v(terms.low, sum_v(product_v(a.high, b.low), product_v(a.low, b.high)));
    const twofoldv two = exact_sum_v(terms.high.x, terms.high.y);
    const twofoldv three = exact_sum_v(two.high, terms.high.z);
    return exact_sum_v(three.high, (two.low + three.low) + (low.x + low.y + low.z));
}

static float3v yzx_v(float3v v) { return (float3v){v.y, v.z, v.x}; }
static float3v zxy_v(float3v v) { return (float3v){v.z, v.x, v.y}; }

static twofold3v twofold_cross_v(twofold3v a, twofold3v b)
{
    const twofold3v plus = exact_product3_v(yzx_v(a.high), zxy_v(b.high));
    const twofold3v minus = exact_product3_v(zxy_v(a.high), yzx_v(b.high));
    const twofold3v difference = exact_sum3_v(plus.high, opposite_v(minus.high));
    const float3v low = minus_v(
        sum_v(product_v(yzx_v(a.high), zxy_v(b.low)), product_v(yzx_v(a.low), zxy_v(b.high))),
        sum_v(product_v(zxy_v(a.high), yzx_v(b.low)), product_v(zxy_v(a.low), yzx_v(b.high))));
    return gathered_v(difference.high,
                      sum_v(difference.low, sum_v(minus_v(plus.low, minus.low), low)));
}

#endif
