// containment.cpp - differences, squares and products of floats in 64 bits of mantissa: their
// rounding (2^-62 relative) is far below the last bit of any float that could decide.
#include "containment.hpp"

#include "../support/rays.hpp"

namespace oracle {
namespace {

using test::Long3;

bool within(Long3 centre, long double radius, Long3 point) {
    const Long3 d = point - centre;
    return dot(d, d) <= radius * radius;
}

}  // namespace

Node child_of(const rsh_node_quad& q, uint32_t k) {
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

bool sphere_contains(const cl_float4& sphere, const test::Corners& corners) {
    const Long3 centre(sphere.s[0], sphere.s[1], sphere.s[2]);
    if (!(sphere.s[3] >= 0)) return false;
    for (const test::Float3& corner : corners)
        if (!within(centre, sphere.s[3], Long3(corner))) return false;
    return true;
}

}  // namespace oracle
