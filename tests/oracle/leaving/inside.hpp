// inside.hpp - whether a point is inside of closed meshes: exactly, by what a line from it crosses.
#pragma once

#include "support/mesh.hpp"

namespace oracle {

// False on the surface. Slow: every triangle counts.
bool is_inside(const test::Mesh& mesh, test::Float3 point);

}  // namespace oracle
