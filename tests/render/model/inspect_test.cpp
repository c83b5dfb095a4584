// inspect_test.cpp - counts of surfaces whose holes, seams and sides are known.
#include "model/inspect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace render {
namespace {

struct Surface {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;

    void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }
    void add(const Surface& other) {
        const glm::uvec3 offset(static_cast<uint32_t>(positions.size()));
        positions.insert(positions.end(), other.positions.begin(), other.positions.end());
        for (const glm::uvec3& t : other.triangles) triangles.push_back(t + offset);
    }
    void turn() {
        for (glm::uvec3& t : triangles) std::swap(t.y, t.z);
    }
};

Surface cube(glm::vec3 low, float side) {
    Surface cube;
    for (int i = 0; i < 8; ++i)
        cube.positions.push_back(low + side * glm::vec3(i & 1, i >> 1 & 1, i >> 2));
    cube.quad(0, 2, 3, 1), cube.quad(4, 5, 7, 6);
    cube.quad(0, 1, 5, 4), cube.quad(2, 6, 7, 3);
    cube.quad(0, 4, 6, 2), cube.quad(1, 3, 7, 5);
    return cube;
}

Inspection inspect(const Surface& surface) {
    return render::inspect(surface.positions, surface.triangles);
}

TEST(Inspect, ACubeIsClosedAndWoundOutwards) {
    const Inspection i = inspect(cube({100, 100, 100}, 2));
    EXPECT_EQ(i.vertices, 8u);
    EXPECT_EQ(i.triangles, 12u);
    EXPECT_EQ(i.components, 1u);
    EXPECT_EQ(i.boundary_edges + i.non_manifold_edges + i.flipped_edges, 0u);
    EXPECT_EQ(i.degenerate_triangles, 0u);
    EXPECT_DOUBLE_EQ(i.volume, 8.0);
    EXPECT_TRUE(i.is_closed);
    EXPECT_TRUE(i.is_wound_outwards);
}

TEST(Inspect, ACubeTurnedInsideOutIsClosedAndWoundInwards) {
    Surface turned = cube({0, 0, 0}, 1);
    turned.turn();
    const Inspection i = inspect(turned);
    EXPECT_DOUBLE_EQ(i.volume, -1.0);
    EXPECT_TRUE(i.is_closed);
    EXPECT_FALSE(i.is_wound_outwards);
}

TEST(Inspect, VerticesThatDifferInAttributesOnlyAreOne) {
    Surface soup;
    const Surface shared = cube({-0.5f, -0.5f, 0}, 1);
    for (const glm::uvec3& t : shared.triangles)
        for (int k = 0; k < 3; ++k) {
            glm::vec3 position = shared.positions[t[k]];
            if (position.z == 0.0f && k == 1) position.z = -0.0f;
            soup.positions.push_back(position);
        }
    for (uint32_t v = 0; v < 36; v += 3) soup.triangles.push_back({v, v + 1, v + 2});
    const Inspection i = inspect(soup);
    EXPECT_EQ(i.vertices, 8u);
    EXPECT_EQ(i.components, 1u);
    EXPECT_TRUE(i.is_closed);
    EXPECT_TRUE(i.is_wound_outwards);
}

TEST(Inspect, AQuadIsOpen) {
    Surface quad;
    quad.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    quad.quad(0, 1, 2, 3);
    const Inspection i = inspect(quad);
    EXPECT_EQ(i.boundary_edges, 4u);
    EXPECT_EQ(i.volume, 0.0);
    EXPECT_FALSE(i.is_closed);
    EXPECT_FALSE(i.is_wound_outwards);
}

TEST(Inspect, AMoebiusStripHasOneSideAndOneBoundary) {
    Surface strip;
    const int n = 12;
    for (int k = 0; k < n; ++k) {
        const float turn = 2 * 3.14159265f * static_cast<float>(k) / n;
        for (const float w : {-0.3f, 0.3f})
            strip.positions.push_back({(1 + w * std::cos(turn / 2)) * std::cos(turn),
                                       (1 + w * std::cos(turn / 2)) * std::sin(turn),
                                       w * std::sin(turn / 2)});
    }
    for (uint32_t k = 0; k + 1 < n; ++k) strip.quad(2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1);
    strip.quad(2 * n - 2, 1, 0, 2 * n - 1);
    const Inspection i = inspect(strip);
    EXPECT_EQ(i.components, 1u);
    EXPECT_EQ(i.boundary_edges, 2u * n);
    EXPECT_EQ(i.non_manifold_edges, 0u);
    EXPECT_EQ(i.flipped_edges, 1u);
    EXPECT_FALSE(i.is_closed);
    EXPECT_FALSE(i.is_wound_outwards);
}

TEST(Inspect, CubesThatShareAnEdgeHaveOneThatIsNotManifold) {
    Surface both = cube({0, 0, 0}, 1);
    both.add(cube({1, 1, 0}, 1));
    const Inspection i = inspect(both);
    EXPECT_EQ(i.vertices, 14u);
    EXPECT_EQ(i.components, 1u);
    EXPECT_EQ(i.non_manifold_edges, 1u);
    EXPECT_EQ(i.boundary_edges, 0u);
    EXPECT_TRUE(i.is_closed) << "a ray that enters either of them leaves it";
    EXPECT_TRUE(i.is_wound_outwards);
}

TEST(Inspect, AFinOnACubeOpensIt) {
    Surface finned = cube({0, 0, 0}, 1);
    finned.positions.push_back({2, 2, 0.5f});
    finned.triangles.push_back({3, 7, 8});
    const Inspection i = inspect(finned);
    EXPECT_EQ(i.non_manifold_edges, 1u);
    EXPECT_EQ(i.boundary_edges, 2u);
    EXPECT_FALSE(i.is_closed);
}

TEST(Inspect, OneTurnedTriangleMakesThreeFlippedEdges) {
    Surface turned = cube({0, 0, 0}, 1);
    std::swap(turned.triangles[5].x, turned.triangles[5].y);
    const Inspection i = inspect(turned);
    EXPECT_EQ(i.flipped_edges, 3u);
    EXPECT_TRUE(i.is_closed);
    EXPECT_FALSE(i.is_wound_outwards);
}

TEST(Inspect, ACavityIsWoundTheOtherWay) {
    Surface hollow = cube({0, 0, 0}, 3), inner = cube({1, 1, 1}, 1);
    hollow.add(inner);
    EXPECT_TRUE(inspect(hollow).is_wound_outwards) << "a solid in a solid";
    inner.turn();
    Surface glass = cube({0, 0, 0}, 3);
    glass.add(inner);
    EXPECT_TRUE(inspect(glass).is_wound_outwards);
    EXPECT_DOUBLE_EQ(inspect(glass).volume, 26.0);
    Surface beside = cube({0, 0, 0}, 3);
    inner.positions = cube({7, 1, 1}, 1).positions;
    beside.add(inner);
    EXPECT_EQ(inspect(beside).components, 2u);
    EXPECT_FALSE(inspect(beside).is_wound_outwards);
}

TEST(Inspect, DegenerateTrianglesAreCountedAndOpenNothing) {
    Surface with = cube({0, 0, 0}, 1);
    with.triangles.push_back({0, 0, 1});  // a repeated vertex
    with.positions.push_back({2, 0, 0});  // in line with 0 and 1
    with.triangles.push_back({0, 1, 8});
    with.positions.push_back({NAN, 0, 0});
    with.triangles.push_back({0, 1, 9});
    const Inspection i = inspect(with);
    EXPECT_EQ(i.triangles, 15u);
    EXPECT_EQ(i.degenerate_triangles, 3u);
    EXPECT_EQ(i.non_manifold_edges, 1u) << "the one in line has edges";
    EXPECT_EQ(i.boundary_edges, 2u);
    EXPECT_DOUBLE_EQ(i.volume, 1.0);
}

TEST(Inspect, AnEmptyMeshHasNothing) {
    const Inspection i = inspect(Surface{});
    EXPECT_EQ(i.vertices + i.triangles + i.components + i.boundary_edges, 0u);
    EXPECT_FALSE(i.is_closed);
    EXPECT_FALSE(i.is_wound_outwards);
}

Model glass(const Surface& surface) {
    Model model;
    model.mesh.positions = surface.positions;
    model.mesh.triangles = surface.triangles;
    model.mesh.material_ids.assign(surface.triangles.size(), 0);
    model.materials.resize(1);
    model.materials[0].name = "ball";
    model.materials[0].transmission = glm::vec3(1.0f);
    model.materials[0].ior = 1.5f;
    return model;
}

TEST(GlassWarnings, NameOpenAndTurnedGlass) {
    Surface surface = cube({0, 0, 0}, 1);
    EXPECT_TRUE(glass_warnings(glass(surface)).empty());
    surface.turn();
    ASSERT_EQ(glass_warnings(glass(surface)).size(), 1u);
    EXPECT_NE(glass_warnings(glass(surface))[0].find("'ball'"), std::string::npos);
    EXPECT_NE(glass_warnings(glass(surface))[0].find("outwards"), std::string::npos);
    surface.triangles.pop_back();
    EXPECT_NE(glass_warnings(glass(surface)).at(0).find("3 boundary and 0 non"),
              std::string::npos);
}

TEST(GlassWarnings, ConcernNeitherOpaqueTrianglesNorThoseThatLightPassesStraight) {
    Model model = glass(cube({0, 0, 0}, 1));
    model.mesh.triangles.pop_back(), model.mesh.material_ids.pop_back();
    model.materials[0].ior = 1.0f;
    EXPECT_TRUE(glass_warnings(model).empty()) << "a see-through leaf may be open";
    model.materials.push_back(Material{});
    model.materials[0].ior = 1.5f;
    model.mesh.material_ids.assign(model.mesh.triangles.size(), 1);
    EXPECT_TRUE(glass_warnings(model).empty()) << "nothing is made of it";
}

}  // namespace
}  // namespace render
