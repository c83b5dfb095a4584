// aff_curve.cpp - keys and a time -> point, rotation, matrix.
#include "import/bart/aff_curve.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace render {
namespace {

// The segment from keys[first] to keys[first + 1], and how far along it the time lies.
struct Segment {
    size_t first = 0;
    double u = 0.0;
};

Segment find_segment(const std::vector<CurveKey>& keys, double time) {
    const size_t last = keys.size() - 3;  // where the last segment starts
    time = std::clamp(time, keys[1].time, keys[last + 1].time);
    size_t first = 1;
    while (first < last && time >= keys[first + 1].time) ++first;
    const double length = keys[first + 1].time - keys[first].time;
    return {first, length > 0.0 ? (time - keys[first].time) / length : 1.0};
}

// Tangents at both ends of the segment P1 P2, from the differences of the values on it and on
// its neighbours (Kochanek and Bartels 1984, eq. 8 and 9), scaled for uneven times: a key's
// tangent is a speed, 2 (t2 - t1) / (t2 - t0) turns it into the parameter of this segment.
struct Tangents {
    glm::dvec3 leaving, arriving;
};

Tangents tangents(const std::vector<CurveKey>& keys, size_t first, glm::dvec3 before,
                  glm::dvec3 here, glm::dvec3 after) {
    const CurveKey &k0 = keys[first - 1], &k1 = keys[first], &k2 = keys[first + 1],
                   &k3 = keys[first + 2];
    const double length = k2.time - k1.time;
    // BART's toy car has keys at equal times: a jump, whose segment has no length.
    const auto scale = [&](double whole, double tension) {
        return whole > 0.0 ? (1.0 - tension) / 2.0 * 2.0 * length / whole : 0.0;
    };
    const double leaving_scale = scale(k2.time - k0.time, k1.tension);
    const double arriving_scale = scale(k3.time - k1.time, k2.tension);
    return {leaving_scale * ((1.0 - k1.continuity) * (1.0 - k1.bias) * here +
                             (1.0 + k1.continuity) * (1.0 + k1.bias) * before),
            arriving_scale * ((1.0 + k2.continuity) * (1.0 - k2.bias) * after +
                              (1.0 - k2.continuity) * (1.0 + k2.bias) * here)};
}

glm::dquat quaternion(const CurveKey& key) {
    return rotation_about(key.value, key.degrees);
}

// The shorter way round from a to b.
glm::dquat nearest(const glm::dquat& a, const glm::dquat& b) {
    return glm::dot(a, b) < 0.0 ? -b : b;
}

// Of a unit quaternion (cos a, n sin a): the vector n a.
glm::dvec3 logarithm(const glm::dquat& q) {
    const glm::dvec3 v(q.x, q.y, q.z);
    const double length = glm::length(v);
    return length == 0.0 ? glm::dvec3(0.0) : v / length * std::atan2(length, q.w);
}

glm::dquat exponential(glm::dvec3 v) {
    const double angle = glm::length(v);
    if (angle == 0.0) return {1.0, 0.0, 0.0, 0.0};
    const glm::dvec3 n = v / angle * std::sin(angle);
    return {std::cos(angle), n.x, n.y, n.z};
}

// Along the arc as it is, which squad needs; glm::slerp would take the shorter one.
glm::dquat slerp(const glm::dquat& a, const glm::dquat& b, double u) {
    return a * exponential(u * logarithm(glm::conjugate(a) * b));
}

}  // namespace

glm::dquat rotation_about(glm::dvec3 axis, double degrees) {
    const double length = glm::length(axis);
    if (length == 0.0) return {1.0, 0.0, 0.0, 0.0};
    return glm::angleAxis(glm::radians(degrees), axis / length);
}

glm::dvec3 point_on_curve(const std::vector<CurveKey>& keys, double time) {
    const auto [i, u] = find_segment(keys, time);
    const glm::dvec3 p1 = keys[i].value, p2 = keys[i + 1].value;
    const Tangents t =
        tangents(keys, i, p1 - keys[i - 1].value, p2 - p1, keys[i + 2].value - p2);
    const double u2 = u * u, u3 = u2 * u;  // cubic Hermite
    return (2.0 * u3 - 3.0 * u2 + 1.0) * p1 + (3.0 * u2 - 2.0 * u3) * p2 +
           (u3 - 2.0 * u2 + u) * t.leaving + (u3 - u2) * t.arriving;
}

// The same tangents on the logarithms of the quaternions between the keys; then Shoemake's
// squad (SIGGRAPH 1987 course notes), whose inner points follow from the tangents.
glm::dquat rotation_on_curve(const std::vector<CurveKey>& keys, double time) {
    const auto [i, u] = find_segment(keys, time);
    const glm::dquat q1 = quaternion(keys[i]);
    const glm::dquat q0 = nearest(q1, quaternion(keys[i - 1]));
    const glm::dquat q2 = nearest(q1, quaternion(keys[i + 1]));
    const glm::dquat q3 = nearest(q2, quaternion(keys[i + 2]));
    const glm::dvec3 here = logarithm(glm::conjugate(q1) * q2);
    const Tangents t = tangents(keys, i, logarithm(glm::conjugate(q0) * q1), here,
                                logarithm(glm::conjugate(q2) * q3));
    const glm::dquat s1 = q1 * exponential((t.leaving - here) / 2.0);
    const glm::dquat s2 = q2 * exponential((here - t.arriving) / 2.0);
    return glm::normalize(slerp(slerp(q1, q2, u), slerp(s1, s2, u), 2.0 * u * (1.0 - u)));
}

glm::dmat4 Track::matrix(double time) const {
    glm::dmat4 m(1.0);
    if (!translation.empty()) m = glm::translate(m, point_on_curve(translation, time));
    if (!rotation.empty()) m = m * glm::mat4_cast(rotation_on_curve(rotation, time));
    if (!scale.empty()) m = glm::scale(m, point_on_curve(scale, time));
    return m;
}

bool Track::is_visible(double time) const {
    bool visible = true;  // before the first key
    for (const VisibilityKey& key : visibility)
        if (time >= key.time) visible = key.is_visible;
    return visible;
}

}  // namespace render
