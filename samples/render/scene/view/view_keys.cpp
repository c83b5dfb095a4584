// view_keys.cpp - linear interpolation of what keys change.
#include "scene/view/view_keys.hpp"

#include <algorithm>

namespace render {
namespace {

// mix(key before, key after, share of the way): both are the same one outside of the keys.
template <typename Key, typename Mix>
auto between_keys(const std::vector<Key>& keys, double time, const Mix& mix) {
    const auto after = std::upper_bound(keys.begin(), keys.end(), time,
                                        [](double t, const Key& key) { return t < key.time; });
    if (after == keys.begin()) return mix(keys.front(), keys.front(), 0.0f);
    if (after == keys.end()) return mix(keys.back(), keys.back(), 0.0f);
    const Key& before = *(after - 1);
    const double u = (time - before.time) / (after->time - before.time);
    return mix(before, *after, static_cast<float>(u));
}

}  // namespace

Camera camera_at(const SceneCamera& camera, double time) {
    if (camera.keys.empty()) return camera;
    return between_keys(camera.keys, time, [](const CameraKey& a, const CameraKey& b, float u) {
        Camera now = a.camera;
        now.eye = glm::mix(a.camera.eye, b.camera.eye, u);
        now.at = glm::mix(a.camera.at, b.camera.at, u);
        now.vertical_degrees =
            glm::mix(a.camera.vertical_degrees, b.camera.vertical_degrees, u);
        return now;
    });
}

Light light_at(const SceneLight& light, double time) {
    if (light.keys.empty()) return light;
    return between_keys(light.keys, time, [](const LightKey& a, const LightKey& b, float u) {
        Light now = a.light;
        now.position = glm::mix(a.light.position, b.light.position, u);
        now.direction = glm::mix(a.light.direction, b.light.direction, u);
        now.colour = glm::mix(a.light.colour, b.light.colour, u);
        return now;
    });
}

bool passes_through_zero(glm::dvec3 from, glm::dvec3 to) {
    constexpr double kSine = 1e-6;
    const double lengths = glm::length(from) * glm::length(to);
    return glm::dot(from, to) < 0.0 && glm::length(glm::cross(from, to)) <= kSine * lengths;
}

}  // namespace render
