// lattice_crossings.cpp - the rule of crossings.hpp in integers. A coordinate across the ray is
//     x - (dx / dz) z,  dz the largest component;
// times |dz| it is an integer below 2^14, of the same sign.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "oracle/crossings/crossings.hpp"
#include "oracle/lattice_numbers.hpp"

namespace oracle {
namespace {

constexpr float kRounding = 0x1p-20f;  // of u and v

int64_t component(Int3 v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// Of components that are equally long the last, but x and y alone: y.
int longest_axis(Int3 d) {
    const int64_t x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
    if (x > y && x > z) return 0;
    return y > z ? 1 : 2;
}

struct Across {
    int64_t x, y;
};

class Plane {
public:
    Plane(Int3 o, Int3 d) : o_(o), d_(d), z_(longest_axis(d)) {}

    Across operator()(Int3 corner) const {
        const Int3 p = corner - o_;
        return {along(p, (z_ + 1) % 3), along(p, (z_ + 2) % 3)};
    }

private:
    int64_t along(Int3 p, int axis) const {
        const int64_t depth = component(d_, z_);
        const int64_t value =
            component(p, axis) * depth - component(d_, axis) * component(p, z_);
        return depth < 0 ? -value : value;
    }

    Int3 o_, d_;
    int z_;
};

int sign(int64_t value) {
    return value < 0 ? -1 : value > 0;
}

// On which side of the line from p to q the point (e, e^2) lies:
//     (p.x - e) (q.y - e^2) - (p.y - e^2) (q.x - e) = p.x q.y - p.y q.x + e (p.y - q.y) + e^2 (q.x - p.x)
int side_of_moved_point(Across p, Across q) {
    if (const int side = sign(p.x * q.y - p.y * q.x)) return side;
    if (const int side = sign(p.y - q.y)) return side;
    return sign(q.x - p.x);
}

bool is_crossed(const LatticeTriangle& triangle, const Plane& plane) {
    Across p[3];
    for (int k = 0; k < 3; ++k) p[k] = plane(triangle.corner[k]);
    const int side = side_of_moved_point(p[0], p[1]);
    return side != 0 && side == side_of_moved_point(p[1], p[2]) &&
           side == side_of_moved_point(p[2], p[0]);
}

bool is_power_of_two(int64_t value) {
    const int64_t size = std::abs(value);
    return size != 0 && (size & (size - 1)) == 0;
}

bool is_zero_or_power(int64_t value) {
    return value == 0 || is_power_of_two(value);
}

// Along one axis, and as long as a power of two.
bool is_leg(Int3 edge) {
    return (edge.x != 0) + (edge.y != 0) + (edge.z != 0) == 1 &&
           is_power_of_two(edge.x + edge.y + edge.z);
}

// Two edges are legs: no float routine rounds its t.
bool has_exact_t(const LatticeTriangle& t) {
    int legs = 0;
    for (int k = 0; k < 3; ++k) legs += is_leg(t.corner[(k + 1) % 3] - t.corner[k]);
    return legs == 2;
}

Int3 exact_direction(const rsh_ray& ray) {
    const Int3 d = lattice_direction(ray);
    for (int axis = 0; axis < 3; ++axis)
        if (!is_zero_or_power(component(d, axis)))
            throw std::invalid_argument("a component of a direction is " +
                                        std::to_string(component(d, axis)) +
                                        ", must be 0 or a power of two");
    return d;
}

// How far from t a float routine may be that rounds nothing before its weights, see intersect.h:
// 20 * 2^-24 of the farthest corner's depth.
double t_error(const LatticeTriangle& triangle, Int3 o, Int3 d) {
    const int axis = longest_axis(d);
    int64_t deepest = 0;
    for (const Int3& corner : triangle.corner)
        deepest = std::max(deepest, std::abs(component(corner - o, axis)));
    return 20 * 0x1p-24 * double(deepest) / std::abs(double(component(d, axis)));
}

// Of a corner: the volume that the ray makes with the edge opposite to it, over that of all three.
float weight(const LatticeTriangle& t, int corner, Int3 o, Int3 d) {
    const Int3 p = t.corner[(corner + 1) % 3] - o, q = t.corner[(corner + 2) % 3] - o;
    return float(double(dot(d, cross(p, q))) / double(dot(d, t.normal)));
}

// False: not within tmin and tmax.
bool locate(const rsh_ray& ray, const LatticeTriangle& triangle, Int3 o, Int3 d,
            Crossing* out) {
    const float tmin = std::fmax(ray.origin_tmin.s[3], 0.0f), tmax = ray.direction_tmax.s[3];
    const Fraction exact = lattice_t(triangle, o, d);
    const double t = double(exact.numerator) / double(exact.denominator);
    *out = {triangle.number,           true,     t, t, weight(triangle, 1, o, d),
            weight(triangle, 2, o, d), kRounding};
    if (has_exact_t(triangle)) return compared(exact, tmin) >= 0 && compared(exact, tmax) <= 0;
    const double error = t_error(triangle, o, d);
    out->t_low = t - error;
    out->t_high = t + error;
    out->is_certain = out->t_low >= tmin && out->t_high <= tmax;
    return out->t_high >= tmin && out->t_low <= tmax;
}

Crossings crossings_of(const std::vector<LatticeTriangle>& triangles, const rsh_ray& ray,
                       uint32_t skipped) {
    const Int3 o = lattice_origin(ray), d = exact_direction(ray);
    const Plane plane(o, d);
    Crossings found;
    for (const LatticeTriangle& triangle : triangles) {
        Crossing crossing;
        if (triangle.number != skipped && is_crossed(triangle, plane) &&
            locate(ray, triangle, o, d, &crossing))
            found.push_back(crossing);
    }
    return found;
}

}  // namespace

std::vector<Crossings> lattice_crossings(const test::Mesh& mesh,
                                         const std::vector<rsh_ray>& rays,
                                         const std::vector<uint32_t>& skip) {
    const std::vector<LatticeTriangle> triangles = lattice_triangles(mesh);
    std::vector<Crossings> all;
    for (size_t i = 0; i < rays.size(); ++i)
        all.push_back(
            test::is_active(rays[i])
                ? crossings_of(triangles, rays[i], skip.empty() ? RSH_NO_HIT : skip[i])
                : Crossings());
    return all;
}

}  // namespace oracle
