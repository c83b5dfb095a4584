// motion.cpp - key frames and placement as matrices.
#include "scene/motion.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <stdexcept>

namespace render {
namespace {

struct Moment {
    glm::vec3 translate;
    glm::dquat rotate;
    float scale;
};

Moment moment_of(const RigidKey& key) {
    return {key.translate, quaternion(key.rotate), key.scale};
}

Moment between(const RigidKey& a, const RigidKey& b, double time) {
    const double u = (time - a.time) / (b.time - a.time);
    return {glm::mix(a.translate, b.translate, static_cast<float>(u)),
            rotation_between(a.rotate, b.rotate, u),
            glm::mix(a.scale, b.scale, static_cast<float>(u))};
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

glm::mat4 motion_at(const std::vector<RigidKey>& keys, double time, glm::vec3 pivot) {
    if (keys.empty()) return glm::mat4(1.0f);
    const Moment now = moment_at(keys, time);
    const glm::mat4 moved = glm::translate(glm::mat4(1.0f), pivot + now.translate);
    const glm::mat4 turned = moved * glm::mat4(glm::mat4_cast(now.rotate));
    return glm::translate(glm::scale(turned, glm::vec3(now.scale)), -pivot);
}

glm::mat4 standing_at(glm::vec3 low, glm::vec3 high, glm::vec3 at, float height) {
    if (!(high.y > low.y))
        throw std::runtime_error("\"stand\" needs a mesh with a height; its box is flat in y");
    const glm::vec3 foot(0.5f * (low.x + high.x), low.y, 0.5f * (low.z + high.z));
    const float scale = height / (high.y - low.y);
    const glm::mat4 placed = glm::translate(glm::mat4(1.0f), at);
    return glm::translate(glm::scale(placed, glm::vec3(scale)), -foot);
}

}  // namespace render
