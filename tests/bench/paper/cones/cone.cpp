// cone.cpp - all tests are one: how far a point is from the bare cone, compared with the radii.
#include "paper/cones/cone.hpp"

#include <algorithm>
#include <cmath>

namespace bench::paper {
namespace {

constexpr double kRightAngle = 1.5707963267948966;

struct Distance {
    double value;
    glm::dvec3 gradient;
};

// From the cone with its apex a point; 0 inside. Convex up to 90 degrees.
Distance distance_to(const Cone& cone, const glm::dvec3& point) {
    const glm::dvec3 way = point - cone.apex;
    const double along = glm::dot(way, cone.axis);
    const glm::dvec3 across = way - along * cone.axis;
    const double off = glm::length(across), c = std::cos(cone.angle), s = std::sin(cone.angle);
    const double side = off * c - along * s;
    if (side <= 0 && along >= 0) return {0, glm::dvec3(0.0)};
    if (along * c + off * s < 0) return {glm::length(way), way / glm::length(way)};
    return {side, c * across / off - s * cone.axis};
}

// The point of the segment that is closest to the cone: the distance is convex along it.
glm::dvec3 closest_on(const Cone& cone, const glm::dvec3& from, const glm::dvec3& to) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
        const double third = (high - low) / 3;
        const double a = low + third, b = high - third;
        const bool falls = distance_to(cone, glm::mix(from, to, a)).value >
                           distance_to(cone, glm::mix(from, to, b)).value;
        (falls ? low : high) = falls ? a : b;
    }
    return glm::mix(from, to, 0.5 * (low + high));
}

}  // namespace

bool Cone::meets_all() const {
    return angle >= kRightAngle;
}

Cone cone_of(const rsh_ray& ray) {
    const cl_float* o = ray.origin_tmin.s;
    const cl_float* d = ray.direction_tmax.s;
    const glm::dvec3 direction(d[0], d[1], d[2]);
    return {{o[0], o[1], o[2]}, glm::normalize(direction), 0, 0};
}

// The axis is the mean of theirs, the centre that of their centres.
Cone merge(const std::vector<Cone>& children) {
    Cone whole;
    double count = 0;
    for (const Cone& child : children) {
        if (child.is_empty()) continue;
        whole.apex += child.apex;
        whole.axis += child.axis;
        ++count;
    }
    if (count == 0) return whole;
    whole.apex /= count;
    const double length = glm::length(whole.axis);
    whole.angle = length > 1e-9 ? 0 : 2 * kRightAngle;
    whole.axis = length > 1e-9 ? whole.axis / length : glm::dvec3(0, 0, 1);
    whole.radius = 0;
    for (const Cone& child : children) {
        if (child.is_empty()) continue;
        const double turn = std::acos(std::clamp(glm::dot(whole.axis, child.axis), -1.0, 1.0));
        whole.angle = std::max(whole.angle, turn + child.angle);
        whole.radius =
            std::max(whole.radius, glm::distance(whole.apex, child.apex) + child.radius);
    }
    return whole;
}

// About the longest side where the opposite angle is not acute, else about the circumcentre.
Sphere sphere_of(const Triangle& triangle) {
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 &a = triangle[i], &b = triangle[(i + 1) % 3],
                         &c = triangle[(i + 2) % 3];
        if (glm::dot(a - c, b - c) <= 0) return {0.5 * (a + b), 0.5 * glm::distance(a, b)};
    }
    const glm::dvec3 u = triangle[1] - triangle[0], v = triangle[2] - triangle[0];
    const glm::dvec3 n = glm::cross(u, v);
    const glm::dvec3 far =
        (glm::dot(u, u) * glm::cross(v, n) + glm::dot(v, v) * glm::cross(n, u)) /
        (2 * glm::dot(n, n));
    return {triangle[0] + far, glm::length(far)};
}

bool meets(const Cone& cone, const Sphere& sphere) {
    return cone.meets_all() ||
           distance_to(cone, sphere.centre).value <= cone.radius + sphere.radius;
}

// The least distance over the triangle, by Frank and Wolfe's method (1956): from the best point so far to
// the corner that the gradient points to. As the distance is convex, the gradient also tells what it is at
// least. What is closer to the radius than a millionth of it is a meeting.
bool meets(const Cone& cone, const Triangle& triangle) {
    if (cone.meets_all()) return true;
    glm::dvec3 point = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
    const double most = cone.radius * (1 + 1e-6);
    for (int step = 0; step < 1000; ++step) {
        const Distance here = distance_to(cone, point);
        if (here.value <= most) return true;
        const glm::dvec3* corner = std::min_element(
            std::begin(triangle), std::end(triangle), [&](const auto& a, const auto& b) {
                return glm::dot(here.gradient, a) < glm::dot(here.gradient, b);
            });
        const double least = here.value + glm::dot(here.gradient, *corner - point);
        if (least > most) return false;
        point = closest_on(cone, point, *corner);
    }
    return true;
}

}  // namespace bench::paper
