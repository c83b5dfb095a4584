/* algebra.cl - the bounds of products, lengths and sums: mesh/intersect.h, mesh/algebra.h,
 * mesh/triangles.h and mesh/twofold.h. */

/* a b - c d: the second product near the first one. */
static void products_input(uint* random, float* input) {
    const float scale = power_random(random, -20, 20);
    for (uint i = 0; i < 4; ++i) input[i] = scale * hard_random(random);
    if (chance(random, 2)) {
        input[3] = input[0] * input[1] / input[2];
        input[3] = as_float(as_uint(input[3]) + below(random, 9) - 4);
    }
}

static bool are_products(const float* input, wide* exact) {
    if (!are_moderate(input, 4, 40)) return false;
    *exact = wide_determinant((wide){input[0], 0}, (wide){input[1], 0}, (wide){input[2], 0},
                              (wide){input[3], 0});
    return exact->high != 0.0;
}

static float difference_of_products_error(const float* input, float most) {
    wide exact;
    if (!are_products(input, &exact)) return -1.0f;
    const double found = difference_of_products(input[0], input[1], input[2], input[3]);
    return fabs((found - exact.high) - exact.low) / (UNIT * fabs(exact.high));
}

static float difference_in_ulps_error(const float* input, float most) {
    wide exact;
    if (!are_products(input, &exact)) return -1.0f;
    const double found = difference_of_products(input[0], input[1], input[2], input[3]);
    return fabs((found - exact.high) - exact.low) / half_ulp(exact.high);
}

static float cross_in_ulps_error(const float* input, float most) {
    wide exact;
    if (!are_products(input, &exact)) return -1.0f;
    const double found =
        cross3((float3)(0.0f, input[0], input[3]), (float3)(0.0f, input[2], input[1])).x;
    return fabs((found - exact.high) - exact.low) / half_ulp(exact.high);
}

#define difference_of_products_input products_input
#define difference_in_ulps_input products_input
#define cross_in_ulps_input products_input
DEFINE_SEARCH(difference_of_products, 4)
DEFINE_SEARCH(difference_in_ulps, 4)
DEFINE_SEARCH(cross_in_ulps, 4)

static void safe_length_input(uint* random, float* input) {
    const float scale = power_random(random, -60, 60);
    for (uint i = 0; i < 3; ++i)
        input[i] = scale * power_random(random, -12, 0) * hard_random(random);
}

static float safe_length_error(const float* input, float most) {
    if (!are_moderate(input, 3, 100)) return -1.0f;
    const double exact = length_of(convert_double3(vector_in(input)));
    if (!(exact > 0.0)) return -1.0f;
    return fabs(safe_length(vector_in(input)) - exact) / (UNIT * exact);
}
DEFINE_SEARCH(safe_length, 3)

/* Two vectors in two floats: high parts, then low ones as shares of half an ulp of these. The second
 * is nearly orthogonal, or parallel, to the first. */
#define TWOFOLDS 12

static void twofolds_input(uint* random, float* input) {
    for (uint i = 0; i < 6; ++i) input[i] = power_random(random, -12, 0) * hard_random(random);
    for (uint i = 6; i < 12; ++i) input[i] = signed_random(random);
    if (chance(random, 3))
        input[5] = -(input[0] * input[3] + input[1] * input[4]) / input[2];
    else if (chance(random, 2))
        for (uint i = 0; i < 3; ++i) input[3 + i] = input[i] * hard_random(random);
}

static twofold3 twofold_in(const float* high, const float* share) {
    const float3 h = vector_in(high);
    return (twofold3){h, clamp(vector_in(share), -1.0f, 1.0f) * (0x1p-24f * fabs(h))};
}

static bool are_twofolds(const float* input, twofold3* a, twofold3* b) {
    if (!are_moderate(input, 6, 20) || !are_moderate(input + 6, 6, 60)) return false;
    *a = twofold_in(input, input + 6);
    *b = twofold_in(input + 3, input + 9);
    return true;
}

static double distance_to(wide exact, float high, float low) {
    return fabs(wide_sum(exact, (wide){-(double)high, -(double)low}).high);
}

/* In units of u^2 of the sum of the terms' sizes. */
static float twofold_dot_error(const float* input, float most) {
    twofold3 a, b;
    if (!are_twofolds(input, &a, &b)) return -1.0f;
    const wide exact = wide_dot(wide3_of(a.high, a.low), wide3_of(b.high, b.low));
    const twofold found = twofold_dot(a, b);
    const double3 term = fabs(convert_double3(a.high) * convert_double3(b.high));
    const double terms = term.x + term.y + term.z;
    if (!(terms > 0.0)) return -1.0f;
    return distance_to(exact, found.high, found.low) / (UNIT * UNIT * terms);
}

static float twofold_cross_error(const float* input, float most) {
    twofold3 a, b;
    if (!are_twofolds(input, &a, &b)) return -1.0f;
    const wide exact = wide_cross(wide3_of(a.high, a.low), wide3_of(b.high, b.low)).x;
    const twofold3 found = twofold_cross(a, b);
    const double terms = fabs((double)a.high.y * b.high.z) + fabs((double)a.high.z * b.high.y);
    if (!(terms > 0.0)) return -1.0f;
    return distance_to(exact, found.high.x, found.low.x) / (UNIT * UNIT * terms);
}

#define twofold_dot_input twofolds_input
#define twofold_cross_input twofolds_input
DEFINE_SEARCH(twofold_dot, TWOFOLDS)
DEFINE_SEARCH(twofold_cross, TWOFOLDS)
