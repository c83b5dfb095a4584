#include "oracle/lattice_numbers.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "oracle/lattice.hpp"

namespace oracle {
namespace {

Int3 integers(test::Float3 v, int limit, const char* what) {
    const auto convert = [&](float x) {
        if (!(std::fabs(x) <= float(limit)) || x != std::trunc(x))
            throw std::invalid_argument(std::string(what) + " is " + std::to_string(x) +
                                        ", must be an integer of at most " +
                                        std::to_string(limit));
        return int64_t(x);
    };
    return {convert(v.x), convert(v.y), convert(v.z)};
}

}  // namespace

bool is_less(Fraction a, Fraction b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
}

// Exact: a float times an integer below 2^25 fits into a double.
int compared(Fraction t, float limit) {
    const double numerator = double(t.numerator), other = double(limit) * double(t.denominator);
    return numerator < other ? -1 : numerator > other;
}

std::vector<LatticeTriangle> lattice_triangles(const test::Mesh& mesh) {
    std::vector<LatticeTriangle> made;
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        test::Corners corners;
        if (!mesh.corners(i, &corners)) continue;
        LatticeTriangle t = {i, {}, {}};
        for (int k = 0; k < 3; ++k)
            t.corner[k] = integers(corners[k], kLatticeReach, "a corner");
        t.normal = cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]);
        made.push_back(t);
    }
    return made;
}

Int3 lattice_origin(const rsh_ray& ray) {
    return integers(test::origin(ray), kLatticeReach, "an origin");
}

Int3 lattice_direction(const rsh_ray& ray) {
    return integers(test::direction(ray), kLatticeDirection, "a direction");
}

Fraction lattice_t(const LatticeTriangle& triangle, Int3 origin, Int3 direction) {
    const Fraction t = {dot(triangle.corner[0] - origin, triangle.normal),
                        dot(direction, triangle.normal)};
    return t.denominator < 0 ? Fraction{-t.numerator, -t.denominator} : t;
}

}  // namespace oracle
