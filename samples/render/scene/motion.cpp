// motion.cpp - key frames and placement as matrices.
#include "scene/motion.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <stdexcept>

namespace render {
namespace {

RigidKey between(const RigidKey& a, const RigidKey& b, double time) {
    const float u = static_cast<float>((time - a.time) / (b.time - a.time));
    RigidKey key;
    key.time = time;
    key.translate = glm::mix(a.translate, b.translate, u);
    key.rotate = glm::slerp(a.rotate, b.rotate, u);
    key.scale = glm::mix(a.scale, b.scale, u);
    return key;
}

RigidKey key_at(const std::vector<RigidKey>& keys, double time) {
    if (time <= keys.front().time) return keys.front();
    if (time >= keys.back().time) return keys.back();
    const auto after =
        std::upper_bound(keys.begin(), keys.end(), time,
                         [](double t, const RigidKey& key) { return t < key.time; });
    return between(*(after - 1), *after, time);
}

}  // namespace

glm::mat4 motion_at(const std::vector<RigidKey>& keys, double time) {
    if (keys.empty()) return glm::mat4(1.0f);
    const RigidKey key = key_at(keys, time);
    const glm::mat4 moved = glm::translate(glm::mat4(1.0f), key.translate);
    return glm::scale(moved * glm::mat4_cast(key.rotate), glm::vec3(key.scale));
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
