// containment.cpp - differences, squares and products of floats in 64 bits of mantissa: their
// rounding (2^-62 relative) is far below the last bit of any float that could decide.
#include "oracle/containment.hpp"

#include "rays/types.h"
#include "support/rays.hpp"

namespace oracle {
namespace {

using test::Long3;

bool within(Long3 centre, long double radius, Long3 point) {
    const Long3 d = point - centre;
    return dot(d, d) <= radius * radius;
}

}  // namespace

Node child_of(const cone_node4& q, uint32_t k) {
    return {{q.apex_x.s[k], q.apex_y.s[k], q.apex_z.s[k]},
            q.radius.s[k],
            {q.axis_x.s[k], q.axis_y.s[k], q.axis_z.s[k]},
            q.sine.s[k]};
}

bool starts_inside(const Node& node, const rsh_ray& ray) {
    return node.radius >= 0 && within(Long3(node.apex), node.radius, Long3(test::origin(ray)));
}

// angle <= half-angle <= 90 degrees  <=>  cos >= 0 and |axis x d| <= sine |axis| |d|.
bool points_inside(const Node& node, const rsh_ray& ray) {
    if (node.sine == 2) return true;
    const Long3 axis(node.axis), d(test::direction(ray));
    const Long3 across = cross(axis, d);
    const long double sine = node.sine;
    return sine >= 0 && sine <= 1 && dot(axis, d) >= 0 && dot(axis, axis) > 0 &&
           dot(across, across) <= sine * sine * dot(axis, axis) * dot(d, d);
}

BoxNode child_of(const box_node16& g, uint32_t k) {
    const auto corner = [k](const float rows[3][16]) {
        return test::Float3(rows[0][k], rows[1][k], rows[2][k]);
    };
    return {corner(g.origin_low), corner(g.origin_high), corner(g.direction_low),
            corner(g.direction_high), g.tmax[k]};
}

bool contains(const BoxNode& node, Long3 start, long double margin, test::Float3 direction) {
    const auto between = [](long double low, long double x, long double high) {
        return low <= x && x <= high;
    };
    const auto has = [&](float low, long double x, float high) {
        return between(low, x - margin, high) && between(low, x + margin, high);
    };
    return has(node.origin_low.x, start.x, node.origin_high.x) &&
           has(node.origin_low.y, start.y, node.origin_high.y) &&
           has(node.origin_low.z, start.z, node.origin_high.z) &&
           between(node.direction_low.x, direction.x, node.direction_high.x) &&
           between(node.direction_low.y, direction.y, node.direction_high.y) &&
           between(node.direction_low.z, direction.z, node.direction_high.z);
}

bool sphere_contains(const cl_float4& sphere, const test::Corners& corners) {
    const Long3 centre(sphere.s[0], sphere.s[1], sphere.s[2]);
    if (!(sphere.s[3] >= 0)) return false;
    for (const test::Float3& corner : corners)
        if (!within(centre, sphere.s[3], Long3(corner))) return false;
    return true;
}

}  // namespace oracle
