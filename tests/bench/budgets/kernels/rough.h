/* rough.h - quotients and roots as far off as OpenCL allows: two ulp up or down, by their bits,
 * beside the half of rounding. In front of the library's kernels. */
#pragma OPENCL FP_CONTRACT OFF

static float rough(float exact) {
    const uint exponent = as_uint(exact) & 0x7f800000u;
    if (exponent < 0x0c800000u || exponent == 0x7f800000u) return exact;
    uint bits = as_uint(exact) * 0x9e3779b9u;
    bits = (bits ^ bits >> 15) * 0x85ebca6bu;
    const float two_ulp = as_float(exponent) * 0x1p-22f;
    return bits & 0x10000u ? exact + two_ulp : exact - two_ulp;
}

static float3 rough3(float3 exact) {
    return (float3)(rough(exact.x), rough(exact.y), rough(exact.z));
}
