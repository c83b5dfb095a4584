// rotation.cpp - axes and degrees, interpolated.
#include "scene/rotation.hpp"

#include <cmath>

namespace render {
namespace {

// 1 or -1: the axes are the same, or opposite; 0: different.
int agreement(glm::dvec3 a, glm::dvec3 b) {
    if (glm::length(glm::cross(a, b)) > 1e-6) return 0;
    return glm::dot(a, b) > 0.0 ? 1 : -1;
}

bool is_whole_turns(const Rotation& r) {
    return std::remainder(r.degrees, 360.0) == 0.0;
}

// `a` and `b` about one axis, as degrees about that of `b`.
glm::dquat turn(double from, const Rotation& b, double u) {
    return quaternion({b.axis, from + u * (b.degrees - from)});
}

}  // namespace

Rotation rotation_of(const glm::dquat& q) {
    const glm::dvec3 v(q.x, q.y, q.z);
    const double length = glm::length(v);
    Rotation r;
    r.has_turns = false;
    if (length == 0.0) return r;
    r.axis = (q.w < 0.0 ? -1.0 : 1.0) / length * v;
    r.degrees = glm::degrees(2.0 * std::atan2(length, std::abs(q.w)));
    return r;
}

glm::dquat quaternion(const Rotation& r) {
    return glm::angleAxis(glm::radians(std::remainder(r.degrees, 720.0)), r.axis);
}

glm::dquat rotation_between(const Rotation& a, const Rotation& b, double u) {
    if (a.has_turns && b.has_turns) {
        if (const int same = agreement(a.axis, b.axis)) return turn(same * a.degrees, b, u);
        if (b.degrees == 0.0) return turn(a.degrees, {a.axis, 0.0}, u);
    }
    if (b.has_turns && is_whole_turns(a)) return turn(0.0, b, u);
    const double turns = std::trunc(b.degrees / 360.0);
    return quaternion({b.axis, 360.0 * turns * u}) *
           glm::slerp(quaternion(a), quaternion(b), u);
}

}  // namespace render
