// motion.hpp - where a mesh stands: on its place, and rigid key frames between which translation and
// scale are interpolated linearly, and rotation as rotation.hpp says.
#pragma once

#include <glm/glm.hpp>

#include <vector>

#include "scene/rotation.hpp"

namespace render {

// p' = pivot + rotate(scale * (p - pivot)) + translate at `time` [s].
struct RigidKey {
    double time = 0.0;
    glm::dvec3 translate{0.0};
    Rotation rotate;
    float scale = 1.0f;
};

// The keys' times ascend; before the first and after the last the motion stands still. Without
// keys: the identity.
glm::dmat4 motion_at(const std::vector<RigidKey>& keys, double time,
                     glm::dvec3 pivot = glm::dvec3(0.0));

// Stands a thing with the bounding box [low, high] upright: the middle of the box's bottom
// comes to `at`, and the box gets the height `height`. Throws when the box is flat in y.
glm::dmat4 standing_at(glm::dvec3 low, glm::dvec3 high, glm::dvec3 at, double height);

}  // namespace render
