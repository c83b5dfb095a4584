/* wide.h - numbers in two doubles, about 106 bits: what the errors of floats are measured against.
 * Sums by Knuth, products by fma, as in mesh/twofold.h, but shares no code with it. */
#ifndef BUDGETS_WIDE_H
#define BUDGETS_WIDE_H

#pragma OPENCL EXTENSION cl_khr_fp64 : enable

typedef struct wide {
    double high, low;
} wide;

typedef struct wide3 {
    wide x, y, z;
} wide3;

static wide wide_two_sum(double a, double b) {
    const double sum = a + b, b_added = sum - a;
    return (wide){sum, (a - (sum - b_added)) + (b - b_added)};
}

static wide wide_minus(wide a) {
    return (wide){-a.high, -a.low};
}

static wide wide_sum(wide a, wide b) {
    const wide high = wide_two_sum(a.high, b.high), low = wide_two_sum(a.low, b.low);
    const wide first = wide_two_sum(high.high, high.low + low.high);
    return wide_two_sum(first.high, first.low + low.low);
}

static wide wide_product(wide a, wide b) {
    const double product = a.high * b.high;
    const double rest = fma(a.high, b.high, -product);
    return wide_two_sum(product, rest + (a.high * b.low + a.low * b.high));
}

static wide3 wide3_sum(wide3 a, wide3 b) {
    return (wide3){wide_sum(a.x, b.x), wide_sum(a.y, b.y), wide_sum(a.z, b.z)};
}

/* The sum of two vectors of floats, exactly; `low` parts of what is held in two floats. */
static wide3 wide3_of(float3 high, float3 low) {
    return (wide3){wide_two_sum(high.x, low.x), wide_two_sum(high.y, low.y),
                   wide_two_sum(high.z, low.z)};
}

static wide3 wide3_scaled(wide factor, wide3 v) {
    return (wide3){wide_product(factor, v.x), wide_product(factor, v.y),
                   wide_product(factor, v.z)};
}

static wide wide_dot(wide3 a, wide3 b) {
    return wide_sum(wide_sum(wide_product(a.x, b.x), wide_product(a.y, b.y)),
                    wide_product(a.z, b.z));
}

static wide wide_determinant(wide a, wide b, wide c, wide d) {
    return wide_sum(wide_product(a, b), wide_minus(wide_product(c, d)));
}

static wide3 wide_cross(wide3 a, wide3 b) {
    return (wide3){wide_determinant(a.y, b.z, a.z, b.y), wide_determinant(a.z, b.x, a.x, b.z),
                   wide_determinant(a.x, b.y, a.y, b.x)};
}

static double3 rounded3(wide3 v) {
    return (double3)(v.x.high, v.y.high, v.z.high);
}
static double3 difference3(float3 a, float3 b) {
    return rounded3(wide3_of(a, -b));
}
static double largest_of3(double3 v) {
    return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}
static double length_of(double3 v) {
    return sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

/* The sine of the angle between two vectors. */
static double sine_between(wide3 a, wide3 b) {
    return length_of(rounded3(wide_cross(a, b))) /
           (length_of(rounded3(a)) * length_of(rounded3(b)));
}

static double half_ulp(double of) {
    return ldexp(1.0, ilogb(of) - 24);
}

static float3 vector_in(const float* input) {
    return (float3)(input[0], input[1], input[2]);
}

/* Whether all numbers of an input are 0 or of 2^-limit to 2^limit: what underflows and overflows
 * has bounds of its own. */
static bool are_moderate(const float* input, uint count, int limit) {
    for (uint i = 0; i < count; ++i)
        if (input[i] != 0.0f &&
            !(fabs(input[i]) >= ldexp(1.0f, -limit) && fabs(input[i]) <= ldexp(1.0f, limit)))
            return false;
    return true;
}

#endif
