// motion_schema.hpp - the scene file's "transform" lists and "keys".
#pragma once

#include <vector>

#include "files/json_value.hpp"
#include "scene/motion.hpp"

namespace render {

// One step or an array of steps {"translate": ...}, {"rotate": ...}, {"scale": ...},
// {"matrix": ...}, applied to the mesh in that order.
glm::dmat4 transform(const JsonValue& value);

std::vector<RigidKey> rigid_keys(const JsonValue& value);

}  // namespace render
