#include "arithmetic/cases.hpp"

#include <cfloat>
#include <cmath>
#include <limits>
#include <random>

namespace rsh {
namespace {

constexpr int kEach = 1024;

class Random {
public:
    // A float with a random sign and fraction, 2^low to 2^high in size.
    double sized(int low, int high) {
        const double size = 1 + below(1u << 23) * 0x1p-23;
        const int exponent = low + static_cast<int>(below(static_cast<cl_uint>(high - low)));
        return static_cast<float>(sign() * std::ldexp(size, exponent));
    }
    double sign() { return below(2) ? 1 : -1; }
    cl_uint below(cl_uint end) { return static_cast<cl_uint>(engine_()) % end; }
    cl_uint odd(cl_uint begin, cl_uint end) { return (begin + below(end - begin)) | 1u; }

private:
    std::mt19937 engine_{1};
};

// Their products and the products' rests are normal, and they fit an int.
Operands usual(Random& random) {
    const auto any = [&] { return random.sized(-20, 31); };
    return {any(), any(), any(), any()};
}

// What is left of a * b + c, or of a * b - c * d, is 0 if the product was rounded, else what that
// lost.
Operands cancelling(Random& random) {
    Operands o = usual(random);
    o.c = random.sign() * static_cast<float>(o.a * o.b);
    o.d = 1;
    return o;
}

// a + b is halfway between floats.
Operands halfway_sum(Random& random) {
    const double even = random.odd(1u << 23, 1u << 24) * 2.0;
    return {random.sign() * even, random.sign(), random.sized(-60, -10), 1};
}

// a * b, of 25 bits, is halfway between floats; fma(a, b, c) is beside that, out of a double's
// reach.
Operands halfway_product(Random& random) {
    const double shift = std::ldexp(1.0, static_cast<int>(random.below(20)) - 10);
    const double a = random.odd(4096, 5792) * random.sign();
    const double b = random.odd(4096, 5792) * random.sign();
    return {a * shift, b, random.sized(-60, -30), 1};
}

// a / b misses the middle between two floats by less than 2^-19 of their distance: an odd b has an
// inverse modulo 2^25, so for small odd r there is an m with m b = 2^25 a + r; that of -r is
// 2^25 - m. All m are odd, and half of them have 25 bits.
Operands halfway_quotient(Random& random) {
    constexpr cl_ulong kModulus = 1u << 25;
    const cl_uint b = random.odd(1u << 23, 1u << 24), r = random.odd(0, 16);
    cl_uint inverse = b;  // Newton's steps: right modulo 2^3, then 2^6, 2^12, 2^24, 2^48
    for (int step = 0; step < 4; ++step) inverse *= 2 - b * inverse;
    const cl_ulong m = r * inverse % kModulus;
    const cl_ulong a = random.below(2) ? (m * b - r) / kModulus  //
                                       : ((kModulus - m) * b + r) / kModulus;
    return {static_cast<double>(a), random.sign() * b, random.sized(-20, 20), 1};
}

// sqrt(1 + 2 n u) = 1 + n u - n^2 u^2 / 2 + ..., with u = 2^-24: beside the middle for small odd n.
Operands halfway_root(Random& random) {
    const double n = random.odd(0, 128);
    const double square = random.below(2) ? 1 + n * 0x1p-23 : 1 - n * 0x1p-24;
    const double a = std::ldexp(square, 2 * static_cast<int>(random.below(20)) - 20);
    return {a, random.sized(-20, 20), random.sized(-20, 20), 1};
}

Cases ordinary(Random& random) {
    Cases cases = {{}, false, (1u << RSH_PROBE_ROWS) - 1};
    for (const auto make :
         {usual, cancelling, halfway_sum, halfway_product, halfway_quotient, halfway_root})
        for (int i = 0; i < kEach; ++i) cases.operands.push_back(make(random));
    return cases;
}

Cases special() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    constexpr double kMax = FLT_MAX, kMin = FLT_MIN;
    const double values[] = {0,     -0.0, 1,     -1,     1.5,       -3,         kMin,
                             -kMin, kMax, -kMax, 0x1p64, kInfinity, -kInfinity, kNaN};
    Cases cases = {{},
                   false,
                   1u << RSH_PROBE_SUM | 1u << RSH_PROBE_DIFFERENCE | 1u << RSH_PROBE_PRODUCT |
                       1u << RSH_PROBE_FMA | 1u << RSH_PROBE_FMA_NEGATED |
                       1u << RSH_PROBE_QUOTIENT | 1u << RSH_PROBE_RECIPROCAL |
                       1u << RSH_PROBE_ROOT | 1u << RSH_PROBE_LESSER | 1u << RSH_PROBE_GREATER |
                       1u << RSH_PROBE_RELATIONS};
    for (const double a : values)
        for (const double b : values)
            for (const double c : {0.0, 1.0, -kInfinity, kNaN})
                cases.operands.push_back({a, b, c, 1});
    return cases;
}

Cases tiny(Random& random) {
    Cases cases = {{},
                   true,
                   1u << RSH_PROBE_SUM | 1u << RSH_PROBE_DIFFERENCE | 1u << RSH_PROBE_PRODUCT |
                       1u << RSH_PROBE_FMA | 1u << RSH_PROBE_FMA_NEGATED |
                       1u << RSH_PROBE_QUOTIENT | 1u << RSH_PROBE_ROOT |
                       1u << RSH_PROBE_RELATIONS};
    const auto small = [&] { return random.sized(-149, -120); };
    for (int i = 0; i < kEach; ++i) {
        cases.operands.push_back({small(), small(), small(), 1});
        cases.operands.push_back({small(), random.sized(-10, 10), small(), 1});
        cases.operands.push_back({random.sized(-75, -60), random.sized(-75, -60), small(), 1});
        cases.operands.push_back({random.sized(-10, 10), random.sized(120, 127), small(), 1});
    }
    return cases;
}

}  // namespace

std::vector<Cases> arithmetic_cases() {
    Random random;
    return {ordinary(random), special(), tiny(random)};
}

}  // namespace rsh
