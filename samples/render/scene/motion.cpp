// motion.cpp - key frames and placement as matrices.
#include "scene/motion.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <stdexcept>

namespace render {
namespace {

struct Moment {
    glm::dvec3 translate;
    glm::dquat rotate;
    double scale;
};

Moment moment_of(const RigidKey& key) {
    return {key.translate, quaternion(key.rotate), key.scale};
}

Moment between(const RigidKey& a, const RigidKey& b, double time) {
    const double u = (time - a.time) / (b.time - a.time);
    return {glm::mix(a.translate, b.translate, u), rotation_between(a.rotate, b.rotate, u),
            glm::mix(double{a.scale}, double{b.scale}, u)};
}

Moment moment_at(const std::vector<RigidKey>& keys, double time) {
    if (time <= keys.front().time) return moment_of(keys.front());
    if (time >= keys.back().time) return moment_of(keys.back());
    const auto after =
        std::upper_bound(keys.begin(), keys.end(), time,
                         [](double t, const RigidKey& key) { return t < key.time; });
    return between(*(after - 1), *after, time);
}

}  // namespace

glm::dmat4 motion_at(const std::vector<RigidKey>& keys, double time, glm::dvec3 pivot) {
    if (keys.empty()) return glm::dmat4(1.0);
    const Moment now = moment_at(keys, time);
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), pivot + now.translate);
    const glm::dmat4 turned = moved * glm::mat4_cast(now.rotate);
    return glm::translate(glm::scale(turned, glm::dvec3(now.scale)), -pivot);
}

glm::dmat4 standing_at(glm::dvec3 low, glm::dvec3 high, glm::dvec3 at, double height) {
    if (!(high.y > low.y))
        throw std::runtime_error("\"stand\" needs a mesh with a height; its box is flat in y");
    const glm::dvec3 foot(0.5 * (low.x + high.x), low.y, 0.5 * (low.z + high.z));
    const double scale = height / (high.y - low.y);
    const glm::dmat4 placed = glm::translate(glm::dmat4(1.0), at);
    return glm::translate(glm::scale(placed, glm::dvec3(scale)), -foot);
}

}  // namespace render
