// model_bounds.hpp - whether what a model names is there, for tests of files that are broken.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "model/model.hpp"

inline void expect_in_bounds(const render::Model& model, const std::string& what) {
    const render::Mesh& mesh = model.mesh;
    ASSERT_EQ(mesh.material_ids.size(), mesh.triangles.size()) << what;
    ASSERT_TRUE(mesh.texcoords.empty() || mesh.texcoords.size() == mesh.positions.size())
        << what;
    ASSERT_TRUE(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size()) << what;
    for (const glm::uvec3 t : mesh.triangles)
        ASSERT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size()) << what;
    for (const uint32_t id : mesh.material_ids) ASSERT_LT(id, model.materials.size()) << what;
}
