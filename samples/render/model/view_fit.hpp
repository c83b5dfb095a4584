// view_fit.hpp - a camera and a light for scenes that bring none.
#pragma once

#include "model/model.hpp"

namespace render {

// Sees all of the mesh from the front, right and above.
Camera camera_that_fits(const Mesh& mesh);

// Shines from behind and above the camera, from its left; casts shadows.
Light light_over_shoulder(const Camera& camera);

}  // namespace render
