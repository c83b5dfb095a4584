// aff_curve.hpp - the key-frame curves of BART's animated transforms (Lext, Assarsson, Moller,
// TR 00-14, 2000): Kochanek-Bartels splines (SIGGRAPH 1984) over keys at uneven times.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <vector>

namespace render {

struct CurveKey {
    double time = 0.0;
    glm::dvec3 value{0.0};  // translation, scale, or the axis of a rotation
    double degrees = 0.0;   // of a rotation
    double tension = 0.0;
    double continuity = 0.0;
    double bias = 0.0;
};

// A curve needs this many keys; the first and the last only give tangents.
constexpr size_t kMinCurveKeys = 4;

// Between the second key and the last but one; the time is clamped to these. `keys` are
// kMinCurveKeys or more, their times do not decrease; between equal times the curve jumps.
glm::dvec3 point_on_curve(const std::vector<CurveKey>& keys, double time);
glm::dquat rotation_on_curve(const std::vector<CurveKey>& keys, double time);

// The rotation by `degrees` about `axis` of any length; the identity if that is 0.
glm::dquat rotation_about(glm::dvec3 axis, double degrees);

struct VisibilityKey {
    double time = 0.0;
    bool is_visible = true;
};

// Keys of one animated transform. No keys of a kind: no movement of that kind.
struct Track {
    std::vector<CurveKey> translation, rotation, scale;
    std::vector<VisibilityKey> visibility;

    // Scales, then rotates, then translates.
    glm::dmat4 matrix(double time) const;
    bool is_visible(double time) const;
};

}  // namespace render
