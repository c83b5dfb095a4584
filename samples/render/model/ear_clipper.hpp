// ear_clipper.hpp - a polygon in a plane -> triangles, ear by ear.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace render {

// Finite corners, at least three, that turn to the left. A polygon that crosses itself may run out
// of ears; then its second corner goes.
//
// An ear is a corner that turns to the left and whose triangle contains no corner that does not.
// One that is not an ear for this reason waits until the corner in its way is gone, so that a few
// tests for each corner are enough; each is a search in a tree. Ears are cut off round by round, not
// one beside the other, which makes triangles that are less thin.
std::vector<glm::uvec3> clip_ears(const std::vector<glm::dvec2>& corners);

}  // namespace render
