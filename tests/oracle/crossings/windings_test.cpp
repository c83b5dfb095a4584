// windings_test.cpp - solid angles against exact crossings of a line, and the closed meshes that they
// are asked of.
#include "oracle/crossings/windings.hpp"

#include <gtest/gtest.h>

#include "oracle/leaving/inside.hpp"
#include "support/closed_meshes.hpp"

namespace {

using test::Float3;
using test::Mesh;

struct Named {
    std::string name;
    Mesh mesh;
    Mesh without_needles =
        {};  // the same, as far as points away from it can tell; none: has none
};

std::vector<Named> closed_meshes() {
    test::Random random(51);
    const Mesh star = test::star(15, 16, 0.2f);
    return {{"sphere", test::sphere(16, 9)},
            {"torus", test::torus(12, 24)},
            {"trefoil", test::trefoil(8, 96)},
            {"lattice box", test::scaled(test::lattice_box(random, 4), 0.25f)},
            {"star", star},
            {"star with needles", test::with_needles(random, star, 100), star}};
}

std::vector<Float3> points_around(uint64_t salt, uint32_t count) {
    test::Random random(salt);
    std::vector<Float3> points;
    for (uint32_t i = 0; i < count; ++i) points.push_back(random.in_cube(1.1f));
    return points;
}

TEST(ClosedMeshes, HaveNoOpenEdges) {
    for (const Named& named : closed_meshes())
        EXPECT_EQ(test::count_open_edges(named.mesh), 0u) << named.name;
    EXPECT_EQ(test::count_open_edges(test::grid(4)), 16u);
}

TEST(ClosedMeshes, ComeOfFillingHoles) {
    Mesh mesh = test::torus(12, 24);
    for (const size_t at : {900u, 303u, 300u, 0u})
        mesh.indices.erase(mesh.indices.begin() + ptrdiff_t(at),
                           mesh.indices.begin() + ptrdiff_t(at) + 3);
    EXPECT_GE(test::count_open_edges(mesh), 9u);
    EXPECT_EQ(test::count_open_edges(test::without_holes(mesh)), 0u);
    EXPECT_EQ(test::count_open_edges(test::without_holes(test::grid(4))), 0u);
}

TEST(OracleWindings, AreOddInside) {
    const std::vector<Float3> points = points_around(52, 300);
    for (const auto& [name, mesh, other] : closed_meshes()) {
        const Mesh& exact = other.vertices.empty() ? mesh : other;
        const auto windings = oracle::windings(mesh, points);
        size_t inside = 0;
        for (size_t i = 0; i < points.size(); ++i) {
            EXPECT_LT(windings[i].off, 1e-9) << name;
            EXPECT_EQ(windings[i].turns % 2 != 0, oracle::is_inside(exact, points[i]))
                << name << ": point " << i << ", turns " << windings[i].turns;
            inside += windings[i].turns != 0;
        }
        EXPECT_GT(inside, 5u) << name;
        EXPECT_LT(inside, 295u) << name;
    }
}

TEST(OracleWindings, AddUp) {
    Mesh three = test::sphere(16, 9);
    const Mesh once = three;
    for (int copy = 0; copy < 2; ++copy)
        three.indices.insert(three.indices.end(), once.indices.begin(), once.indices.end());
    EXPECT_EQ(std::abs(oracle::windings(three, {{0.1f, 0.2f, 0.3f}})[0].turns), 3);
    EXPECT_EQ(oracle::windings(three, {{1, 0.2f, 0.3f}})[0].turns, 0);
}

TEST(OracleWindings, SayThatAMeshIsNotClosed) {
    Mesh open = test::sphere(16, 9);
    open.indices.resize(open.indices.size() - 3);
    EXPECT_GT(oracle::windings(open, {{0, 0, 0}})[0].off, 1e-3);
}

TEST(OracleDistance, IsThatOfTheNearestTriangle) {
    Mesh mesh;
    mesh.add({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    mesh.add({0, 0, 50}, {4, 0, 50}, {4, 0, 50});
    EXPECT_EQ(oracle::distance_to_surface(mesh, {1, 1, 2}), 2);
    EXPECT_EQ(oracle::distance_to_surface(mesh, {2, -3, 4}), 5);
    EXPECT_EQ(oracle::distance_to_surface(mesh, {-3, -4, 0}), 5);
    EXPECT_NEAR(oracle::distance_to_surface(mesh, {4, 4, 0}), std::sqrt(8.0), 1e-12);
    EXPECT_EQ(oracle::distance_to_surface(mesh, {2, 0, 49}), 1);
}

}  // namespace
