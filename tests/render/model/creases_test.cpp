// creases_test.cpp - which vertices a mesh is cut at, and the normals that this leads to.
#include "model/creases.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/normals.hpp"

namespace render {
namespace {

Mesh cube() {
    Mesh cube;
    for (int i = 0; i < 8; ++i) cube.positions.push_back({i & 1, i >> 1 & 1, i >> 2});
    for (const glm::uvec4 q : {glm::uvec4(0, 2, 3, 1),
                               {4, 5, 7, 6},
                               {0, 1, 5, 4},
                               {2, 6, 7, 3},
                               {0, 4, 6, 2},
                               {1, 3, 7, 5}}) {
        cube.triangles.push_back({q.x, q.y, q.z});
        cube.triangles.push_back({q.x, q.z, q.w});
    }
    return cube;
}

glm::vec3 face_normal(const Mesh& mesh, const glm::uvec3& t) {
    return glm::normalize(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                     mesh.positions[t.z] - mesh.positions[t.x]));
}

TEST(Creases, OfACubeAreAllItsEdgesButNoDiagonal) {
    const CreasedMesh creased = split_at_creases(cube(), 89.0f);
    EXPECT_EQ(creased.mesh.positions.size(), 24u);
    const std::vector<glm::vec3> normals = smooth_normals(creased.mesh);
    for (size_t i = 0; i < 12; ++i)
        for (int k = 0; k < 3; ++k) {
            const uint32_t v = creased.mesh.triangles[i][k];
            EXPECT_EQ(creased.source[v], cube().triangles[i][k]);
            EXPECT_EQ(creased.mesh.positions[v], cube().positions[creased.source[v]]);
            EXPECT_EQ(normals[v], face_normal(creased.mesh, creased.mesh.triangles[i]));
        }
    EXPECT_EQ(split_at_creases(cube(), 91.0f).mesh.positions.size(), 8u);
}

// A closed prism: its mantle is smooth, its lids are not.
TEST(Creases, LeaveTheMantleOfAPrismInOnePiece) {
    Mesh prism;
    const uint32_t n = 32;
    for (uint32_t k = 0; k < n; ++k) {
        const double turn = 2.0 * M_PI * k / n;
        for (const float z : {0.0f, 1.0f})
            prism.positions.push_back({std::cos(turn), std::sin(turn), z});
    }
    for (uint32_t k = 0; k < n; ++k) {
        const uint32_t a = 2 * k, b = 2 * ((k + 1) % n);
        prism.triangles.push_back({a, b, b + 1});
        prism.triangles.push_back({a, b + 1, a + 1});
        if (k == 0 || k == n - 1) continue;
        prism.triangles.push_back({0, b, a});
        prism.triangles.push_back({1, a + 1, b + 1});
    }
    const CreasedMesh creased = split_at_creases(prism, 45.0f);
    EXPECT_EQ(creased.mesh.positions.size(), 4u * n) << "once in the mantle, once in a lid";
    for (const glm::vec3& normal : smooth_normals(creased.mesh))
        EXPECT_TRUE(std::abs(std::abs(normal.z) - 1.0f) < 1e-6f || std::abs(normal.z) < 1e-6f);
}

TEST(Creases, CopyNormalsAndTextureCoordinatesToo) {
    Mesh mesh = cube();
    for (uint32_t v = 0; v < 8; ++v) {
        mesh.normals.push_back(glm::vec3(static_cast<float>(v)));
        mesh.texcoords.push_back(glm::vec2(static_cast<float>(v)));
    }
    const CreasedMesh creased = split_at_creases(mesh, 10.0f);
    ASSERT_EQ(creased.mesh.normals.size(), 24u);
    ASSERT_EQ(creased.mesh.texcoords.size(), 24u);
    for (size_t v = 0; v < 24; ++v) {
        EXPECT_EQ(creased.mesh.normals[v].x, static_cast<float>(creased.source[v]));
        EXPECT_EQ(creased.mesh.texcoords[v].y, static_cast<float>(creased.source[v]));
    }
}

// Three quads around an edge, a triangle without area, one turned over, and an open boundary.
TEST(Creases, KeepEveryTriangleOfABrokenMesh) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0},  {1, 0, 1},
                      {0, 1, 0}, {0, 1, 1}, {-1, 0, 0}, {-1, 0, 1}};
    mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4},
                      {0, 1, 7}, {0, 7, 6}, {2, 2, 3}, {2, 3, 0}};
    const CreasedMesh creased = split_at_creases(mesh, 30.0f);
    ASSERT_EQ(creased.mesh.triangles.size(), mesh.triangles.size());
    for (size_t i = 0; i < mesh.triangles.size(); ++i)
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(creased.source.at(creased.mesh.triangles[i][k]), mesh.triangles[i][k]);
    EXPECT_EQ(creased.source.size(), creased.mesh.positions.size());
}

TEST(Creases, OfAnEmptyMeshAreNone) {
    EXPECT_TRUE(split_at_creases(Mesh{}, 30.0f).mesh.positions.empty());
}

}  // namespace
}  // namespace render
