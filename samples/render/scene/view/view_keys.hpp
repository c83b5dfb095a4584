// view_keys.hpp - the camera and the lights of a scene file, which may move by key frames: linear between
// them, still before the first and after the last.
#pragma once

#include <vector>

#include "model/model.hpp"

namespace render {

// As it is at `time` [s].
struct CameraKey {
    double time = 0.0;
    Camera camera;
};

struct LightKey {
    double time = 0.0;
    Light light;
};

// With keys, these alone count.
struct SceneCamera : Camera {
    std::vector<CameraKey> keys;
};

struct SceneLight : Light {
    std::vector<LightKey> keys;
};

// Eye, at and the field of view change.
Camera camera_at(const SceneCamera& camera, double time);

// Position, direction and colour change; a spot that shines at a place does so between its keys too.
Light light_at(const SceneLight& light, double time);

// Whether the straight way from one to the other passes through 0, or so near that floats cannot tell
// its direction there.
bool passes_through_zero(glm::dvec3 from, glm::dvec3 to);

}  // namespace render
