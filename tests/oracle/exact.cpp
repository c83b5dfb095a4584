// exact.cpp - sums and products of expansions. Compiled without floating-point contraction.
#include "oracle/exact.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace oracle {
namespace {

// Components from small to large, none zero.
using Expansion = std::vector<double>;

// Knuth's two-sum: sum + error == a + b.
double two_sum(double a, double b, double* error) {
    const double sum = a + b;
    const double b_part = sum - a;
    *error = (a - (sum - b_part)) + (b - b_part);
    return sum;
}

// Shewchuk's Grow-Expansion, zeros left out.
Expansion grow(const Expansion& e, double b) {
    Expansion result;
    double q = b;
    for (const double component : e) {
        double error;
        q = two_sum(q, component, &error);
        if (error != 0) result.push_back(error);
    }
    if (q != 0) result.push_back(q);
    return result;
}

Expansion sum(Expansion a, const Expansion& b) {
    for (const double component : b) a = grow(a, component);
    return a;
}

Expansion product(const Expansion& a, const Expansion& b) {
    Expansion result;
    for (const double x : a)
        for (const double y : b) {
            const double high = x * y;
            result = grow(grow(result, std::fma(x, y, -high)), high);
        }
    return result;
}

Expansion negated(Expansion a) {
    for (double& component : a) component = -component;
    return a;
}

using Vector = std::array<Expansion, 3>;

Expansion difference(float a, float b) {
    return grow(grow({}, double(a)), -double(b));
}

Vector difference(test::Float3 a, test::Float3 b) {
    return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
}

// All rounding errors of a sum of three products of three differences, relative to its terms'
// absolute values: a difference, two products, two sums each, and as much again to spare.
constexpr long double kError = 16 * std::numeric_limits<long double>::epsilon();

// Sign of d . (p x q): by floating point where it can tell, else exactly.
int sign_of_volume(const Vector& d, const Vector& p, const Vector& q) {
    const auto fast = [](const Expansion& e) {
        long double value = 0;
        for (const double component : e) value += component;
        return value;
    };
    long double volume = 0, size = 0;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const long double a = fast(p[j]) * fast(q[k]), b = fast(p[k]) * fast(q[j]);
        volume += fast(d[i]) * (a - b);
        size += std::fabs(fast(d[i])) * (std::fabs(a) + std::fabs(b));
    }
    if (std::fabs(volume) > kError * size) return volume > 0 ? 1 : -1;
    Expansion exact;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        exact =
            sum(exact, product(d[i], sum(product(p[j], q[k]), negated(product(p[k], q[j])))));
    }
    if (exact.empty()) return 0;
    return exact.back() > 0 ? 1 : -1;
}

}  // namespace

int side_of_edge(test::Float3 o, test::Float3 d, test::Float3 p, test::Float3 q) {
    return sign_of_volume(difference(d, {}), difference(p, o), difference(q, o));
}

int side_of_plane(test::Float3 o, const std::array<test::Float3, 3>& corners) {
    return sign_of_volume(difference(o, corners[0]), difference(corners[1], corners[0]),
                          difference(corners[2], corners[0]));
}

}  // namespace oracle
