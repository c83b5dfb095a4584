#include "arithmetic/answers.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>

namespace rsh {
namespace {

double rounded(double value) {
    return static_cast<float>(value);
}

// Of a sum that does not overflow the rest is a float, and so is what is left of the smaller one.
double sum_rest(double a, double b) {
    const double sum = rounded(a + b);
    const double large = std::fabs(a) < std::fabs(b) ? b : a;
    const double small = std::fabs(a) < std::fabs(b) ? a : b;
    return rounded(small - rounded(sum - large));
}

// Rounded once, unlike the same in double.
double fused(double a, double b, double c) {
    return std::fma(static_cast<float>(a), static_cast<float>(b), static_cast<float>(c));
}

double relations(double a, double b) {
    return (a < b ? RSH_PROBE_IS_LESS : 0) | (a <= b ? RSH_PROBE_IS_AT_MOST : 0) |
           (a > b ? RSH_PROBE_IS_MORE : 0) | (a >= b ? RSH_PROBE_IS_AT_LEAST : 0) |
           (a == b ? RSH_PROBE_IS_EQUAL : 0) | (a != b ? RSH_PROBE_IS_OTHER : 0) |
           (std::isnan(a) ? RSH_PROBE_IS_NAN : 0) |
           (std::isinf(a) ? RSH_PROBE_IS_INFINITE : 0) |
           (std::isfinite(a) ? RSH_PROBE_IS_FINITE : 0);
}

double bits_as_int(double a) {
    const float value = static_cast<float>(a);
    cl_int bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

double flushed(double a) {
    return std::fabs(a) < FLT_MIN ? 0 : a;
}

using O = const Operands&;
constexpr cl_uint kRounding = RSH_ARITHMETIC_ROUNDING;
constexpr cl_uint kContraction = RSH_ARITHMETIC_CONTRACTION;
constexpr cl_uint kFma = RSH_ARITHMETIC_FMA;
constexpr cl_uint kComparison = RSH_ARITHMETIC_COMPARISON;
constexpr cl_uint kConversion = RSH_ARITHMETIC_CONVERSION;
constexpr Operation kOperations[] = {
    {RSH_PROBE_SUM, kRounding, "a + b", false, [](O o) { return o.a + o.b; }},
    {RSH_PROBE_DIFFERENCE, kRounding, "a - b", false, [](O o) { return o.a - o.b; }},
    {RSH_PROBE_PRODUCT, kRounding, "a * b", false, [](O o) { return o.a * o.b; }},
    {RSH_PROBE_SUM_REST, kRounding, "the rest of a + b", false,
     [](O o) { return sum_rest(o.a, o.b); }},
    {RSH_PROBE_PRODUCT_PLUS, kContraction, "a * b + c", false,
     [](O o) { return rounded(o.a * o.b) + o.c; }},
    {RSH_PROBE_MINUS_PRODUCT, kContraction, "c - a * b", false,
     [](O o) { return o.c - rounded(o.a * o.b); }},
    {RSH_PROBE_TWO_PRODUCTS, kContraction, "a * b - c * d", false,
     [](O o) { return rounded(o.a * o.b) - rounded(o.c * o.d); }},
    {RSH_PROBE_FMA, kFma, "fma(a, b, c)", false, [](O o) { return fused(o.a, o.b, o.c); }},
    {RSH_PROBE_FMA_NEGATED, kFma, "fma(-a, b, c)", false,
     [](O o) { return fused(-o.a, o.b, o.c); }},
    {RSH_PROBE_PRODUCT_REST, kFma, "fma(a, b, -(a * b))", false,
     [](O o) { return o.a * o.b - rounded(o.a * o.b); }},
    {RSH_PROBE_QUOTIENT, RSH_ARITHMETIC_DIVISION, "a / b", false,
     [](O o) { return o.a / o.b; }},
    {RSH_PROBE_RECIPROCAL, RSH_ARITHMETIC_DIVISION, "1 / b", false,
     [](O o) { return 1 / o.b; }},
    {RSH_PROBE_ROOT, RSH_ARITHMETIC_SQUARE_ROOT, "sqrt(a)", false,
     [](O o) { return std::sqrt(o.a); }},
    {RSH_PROBE_LESSER, kComparison, "fmin(a, b)", false,
     [](O o) { return std::fmin(o.a, o.b); }},
    {RSH_PROBE_GREATER, kComparison, "fmax(a, b)", false,
     [](O o) { return std::fmax(o.a, o.b); }},
    {RSH_PROBE_RELATIONS, kComparison, "what holds of a and b (RSH_PROBE_IS_...)", true,
     [](O o) { return relations(o.a, o.b); }},
    {RSH_PROBE_FLOAT_OF_INT, kConversion, "the float of a's bits as int", false,
     [](O o) { return bits_as_int(o.a); }},
    {RSH_PROBE_INT_OF_FLOAT, kConversion, "the int of a", true,
     [](O o) { return std::trunc(o.a); }},
    {RSH_PROBE_FLOOR, kConversion, "floor(a)", false, [](O o) { return std::floor(o.a); }},
};

// The distance of floats around a value, denormals included.
double ulp_of(double value) {
    return std::ldexp(1.0, std::max(std::ilogb(value), FLT_MIN_EXP - 1) - (FLT_MANT_DIG - 1));
}

}  // namespace

Operations operations() {
    return kOperations;
}

Operands flushed(const Operands& o) {
    return {flushed(o.a), flushed(o.b), flushed(o.c), flushed(o.d)};
}

bool is_right(float found, double answer, double ulps) {
    const float nearest = static_cast<float>(answer);
    if (std::isnan(answer)) return std::isnan(found);
    if (found == nearest) return true;
    if (std::fabs(answer) < FLT_MIN && found == 0) return true;
    return std::isfinite(nearest) && std::fabs(found - answer) <= ulps * ulp_of(answer);
}

}  // namespace rsh
