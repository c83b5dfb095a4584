// aim.hpp - squares of rays at a mesh.
#pragma once

#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace bench::stability {

// From all around, each at a point of a triangle, which rounding may put beside it.
test::Rays rays_at_triangles(test::Random& random, const test::Mesh& mesh, uint32_t side);

// At vertices and edges, from points within `reach` of the middle.
test::Rays rays_from(test::Random& random, const test::Mesh& mesh, uint32_t side, float reach);

}  // namespace bench::stability
