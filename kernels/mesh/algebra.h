/* algebra.h - products and lengths of 3-vectors with every rounding spelled out: the built-in
 * dot, cross and normalize are free to differ between devices. */
#ifndef RSH_MESH_ALGEBRA_H
#define RSH_MESH_ALGEBRA_H

#include "mesh/triangles.h"

static float dot3(float3 a, float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static float largest3(float3 v) { return fmax(v.x, fmax(v.y, v.z)); }

/* The power of two that brings a size to 1 .. 2, as far as floats go: products of what is
 * scaled by it neither overflow nor vanish. */
static float scale_to_one(float size)
{
    const int exponent = clamp(as_int(size) & 0x7f800000, 0x00800000, 0x7e000000);
    return as_float(0x7f000000 - exponent);
}

/* Each component within 1.5 ulp (Kahan): `error` is the rounding of the second product. */
static float3 cross3(float3 a, float3 b)
{
    const float3 product = a.zxy * b.yzx;
    const float3 error = fma(-a.zxy, b.yzx, product);
    return fma(a.yzx, b.zxy, -product) + error;
}

/* Unit vector for any finite length; 0 for a vector that has no direction. */
static float3 unit3(float3 v)
{
    const float size = largest3(fabs(v));
    if (!is_finite3(v) || !(size > 0.0f)) return (float3)(0.0f);
    const float3 w = scale_to_one(size) * v;
    return w / sqrt(dot3(w, w));
}

#endif
