// rotation.hpp - rotations as a scene file asks for them, turns included, which a quaternion alone
// forgets; and the way from one to the next.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace render {

struct Rotation {
    glm::dvec3 axis{0.0, 1.0, 0.0};  // unit
    double degrees = 0.0;            // 720 are two turns
    bool has_turns = true;           // false: from a quaternion, so at most half a turn
};

// `q` is not zero.
Rotation rotation_of(const glm::dquat& q);

glm::dquat quaternion(const Rotation& rotation);

// From `a` (u = 0) to `b` (u = 1). About one axis, the degrees go linearly: from 0 to 270 the long
// way, from 0 to -90 backwards. Whole turns are 0 degrees about any axis that comes next, and 0
// degrees are so about any axis. Between different axes, or where one is a quaternion: the shorter
// way (slerp, Shoemake 1985), with the whole turns of `b` about its axis on top.
glm::dquat rotation_between(const Rotation& a, const Rotation& b, double u);

}  // namespace render
