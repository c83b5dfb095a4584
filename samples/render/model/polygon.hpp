// polygon.hpp - splits one polygon into triangles. Always yields corner count - 2 of them, also
// for degenerate and non-finite corners, so that promised and actual counts can be compared. Takes
// n log n for convex polygons, stars, combs and spirals.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace render {

// Corners into `corners`; a fan for convex polygons, ears for concave ones. A polygon of fewer
// than three corners has no triangle.
std::vector<glm::uvec3> triangulate(const std::vector<glm::dvec3>& corners);

}  // namespace render
