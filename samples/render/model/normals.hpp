// normals.hpp - vertex normals for meshes that come without. Splits no vertex: an edge between
// two faces that share its vertices becomes smooth.
#pragma once

#include "model/model.hpp"

namespace render {

// One unit normal per vertex, the mean of its triangles' normals weighted by their areas; zero
// where there is none.
std::vector<glm::vec3> smooth_normals(const Mesh& mesh);

}  // namespace render
