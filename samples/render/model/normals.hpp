// normals.hpp - vertex normals for meshes that come without.
#pragma once

#include "model/model.hpp"

namespace render {

// One unit normal per vertex, the mean of its triangles' normals weighted by their areas; zero
// where there is none. Vertices of the same group, if there are groups, get the same normal.
std::vector<glm::vec3> smooth_normals(const Mesh& mesh,
                                      const std::vector<uint32_t>& groups = {});

}  // namespace render
