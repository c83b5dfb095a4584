// exact.cpp - sums and products of expansions. Compiled without floating-point contraction.
#include "oracle/exact.hpp"

#include <cmath>
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

Expansion difference(float a, float b) {
    return grow(grow({}, double(a)), -double(b));
}

// d * (a * b - c * e)
Expansion minor(float d, const Expansion& a, const Expansion& b, const Expansion& c,
                const Expansion& e) {
    return product(grow({}, double(d)), sum(product(a, b), negated(product(c, e))));
}

}  // namespace

int side_of_edge(test::Float3 o, test::Float3 d, test::Float3 p, test::Float3 q) {
    const Expansion px = difference(p.x, o.x), py = difference(p.y, o.y);
    const Expansion pz = difference(p.z, o.z), qx = difference(q.x, o.x);
    const Expansion qy = difference(q.y, o.y), qz = difference(q.z, o.z);
    const Expansion volume = sum(sum(minor(d.x, py, qz, pz, qy), minor(d.y, pz, qx, px, qz)),
                                 minor(d.z, px, qy, py, qx));
    if (volume.empty()) return 0;
    return volume.back() > 0 ? 1 : -1;
}

}  // namespace oracle
