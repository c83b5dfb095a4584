// tree_test.cpp - nodes of bounds that are kept (RSH_BOUND_QUALITY), out of a binary tree:
// they hold what is below them, there is room for them and for what a ray leaves on its stack,
// and their boxes are smaller than those of ranges along the curve.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bvh/box_checks.hpp"
#include "bvh/types.h"
#include "support/cases.hpp"

namespace {

using test::Float3;

class BoxTree : public ::testing::TestWithParam<test::NamedCase> {};

// bvh/collapse16.h.
size_t most_nodes(size_t leaves) {
    return std::max<size_t>(1, (leaves - 1) / 8);
}

void expect_kept(const test::Mesh& mesh) {
    const test::DeviceMesh scene(mesh);
    for (const test::SceneBvh& bvh : test::kept_bvhs({&scene, &scene})) {
        BvhCounts counts;
        expect_contained(mesh, bvh, &counts);
        if (counts.leaves) {
            EXPECT_LE(counts.nodes, most_nodes(counts.leaves));
        }
    }
}

TEST_P(BoxTree, HoldsWhatIsBelowIt) {
    test::Random random(30);
    expect_kept(GetParam().make(random).mesh);
}

INSTANTIATE_TEST_SUITE_P(All, BoxTree, ::testing::ValuesIn(test::all_cases()), test::case_name);

void add_clump(test::Mesh& mesh, test::Random& random, Float3 at, float size) {
    for (uint32_t i = 0; i < 15; ++i) {
        const Float3 p = at + size * random.direction();
        mesh.add(p, p + Float3(0.2f * size, 0, 0), p + Float3(0, 0.2f * size, 0.2f * size));
    }
}

// Each box is closer to the one before than to the next: all would go into one chain.
TEST(BoxTrees, OfGrowingDistancesAreNotDeep) {
    test::Random random(31);
    for (const float growth : {1.05f, 1.2f, 1.6f}) {
        SCOPED_TRACE("growth " + std::to_string(growth));
        test::Mesh mesh;
        float x = 1e-10f;
        for (int i = 0; i < (test::small() ? 40 : 400) && x < 1e18f; ++i, x *= growth)
            add_clump(mesh, random, Float3(x, 0, 0), 0.01f * x);
        expect_kept(mesh);
    }
}

// By their surfaces alone, the two leaves at each place would make a node, more nodes than
// there is room for.
TEST(BoxTrees, OfTwosThatStandApart) {
    test::Random random(35);
    const int side = test::small() ? 1 : 6;
    test::Mesh mesh;
    for (int cell = 0; cell < side * side * side; ++cell)
        for (int place = 0; place < 16; ++place) {
            const Float3 corner(float(cell % side), float(cell / side % side),
                                float(cell / side / side));
            const Float3 at = corner + 0.25f * Float3(float(place & 1) * 2, float(place & 2),
                                                      float(place / 4));
            for (int k = 0; k < 2; ++k)
                add_clump(mesh, random, at + Float3(0.004f * float(k), 0, 0), 0.001f);
        }
    expect_kept(mesh);
}

// mesh/intersect.h scales the triangles of one of the frames, not of the other.
TEST(BoxTrees, FitTrianglesOfAnotherSize) {
    test::Random random(36);
    const test::Mesh large = test::random_soup(random, 500);
    test::Mesh tiny = large;
    for (Float3& v : tiny.vertices) v = 0x1p-30f * v;
    const test::DeviceMesh first(large), second(tiny);
    const std::vector<test::SceneBvh> bvhs = test::kept_bvhs({&first, &second, &first});
    expect_contained(large, bvhs[0]);
    expect_contained(tiny, bvhs[1]);
    expect_contained(large, bvhs[2]);
    EXPECT_EQ(bvhs[0].order, bvhs[1].order) << "it was not kept";
}

// All pairs alike; no surface at all; surfaces that overflow.
TEST(BoxTrees, OfBoxesAllAlike) {
    const uint32_t side = test::small() ? 8 : 60;
    for (const float size : {1.0f, 0.0f, 1e18f}) {
        SCOPED_TRACE("size " + std::to_string(size));
        test::Mesh mesh;
        for (uint32_t i = 0; i < side * side; ++i) {
            const Float3 at = size * Float3(float(i % side), float(i / side), 0);
            for (int k = 0; k < 8; ++k)
                mesh.add(at, at + Float3(0.5f * size, 0, 0), at + Float3(0, 0.5f * size, 0));
        }
        expect_kept(mesh);
    }
}

// Half surfaces of all nodes' boxes below a node, and of its own.
double surface_below(const test::SceneBvh& bvh, uint32_t number) {
    const bvh_node& node = bvh.nodes[number];
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    double sum = 0;
    for (int k = 0; k < 16; ++k) {
        if (node.child[k] == RSH_NO_CHILD) continue;
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min<double>(low[axis], node.low[axis][k]);
            high[axis] = std::max<double>(high[axis], node.high[axis][k]);
        }
        if (!(node.child[k] & RSH_IS_LEAF)) sum += surface_below(bvh, node.child[k]);
    }
    const double x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return sum + x * y + y * z + z * x;
}

// What a ray alone opens is in proportion to it. Small objects stand on a floor, on walls.
TEST(BoxTrees, HaveLessSurfaceThanRuns) {
    for (const uint32_t seed : {32u, 33u, 34u}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        test::Random random(seed);
        test::Mesh mesh;
        for (int i = 0; i < (test::small() ? 8 : 40); ++i) {
            Float3 at(random.unit(), random.unit(), random.unit());
            (i % 3 ? i % 3 == 1 ? at.x : at.y : at.z) = 0;
            const float size = 0.01f * std::exp2(3 * random.unit());
            for (int k = 0; k < 20; ++k)
                add_clump(mesh, random, at + size * random.direction(), 0.2f * size);
            add_clump(mesh, random, at, 0.1f);
        }
        const test::DeviceMesh scene(mesh);
        const test::SceneBvh ranges = test::build_bvh(scene);
        const test::SceneBvh tree = test::kept_bvhs({&scene})[0];
        EXPECT_LT(surface_below(tree, tree.top()), 0.8 * surface_below(ranges, ranges.top()));
    }
}

}  // namespace
