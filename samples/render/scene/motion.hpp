// motion.hpp - where a mesh stands: static transforms, and rigid key frames between which
// translation and scale are interpolated linearly and rotation by slerp (Shoemake 1985).
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <vector>

namespace render {

// p' = rotate(scale * p) + translate at `time` [s].
struct RigidKey {
    double time = 0.0;
    glm::vec3 translate{0.0f};
    glm::quat rotate{1.0f, 0.0f, 0.0f, 0.0f};
    float scale = 1.0f;
};

// The keys' times ascend; before the first and after the last the motion stands still. Without
// keys: the identity.
glm::mat4 motion_at(const std::vector<RigidKey>& keys, double time);

// Stands a thing with the bounding box [low, high] upright: the middle of the box's bottom
// comes to `at`, and the box gets the height `height`. Throws when the box is flat in y.
glm::mat4 standing_at(glm::vec3 low, glm::vec3 high, glm::vec3 at, float height);

}  // namespace render
