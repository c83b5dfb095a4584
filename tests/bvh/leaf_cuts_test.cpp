// leaf_cuts_test.cpp - where the shape `box` cuts its order of triangles into leaves, and these
// into nodes: between what lies apart, and with the least surface that any cuts have.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bvh/box_checks.hpp"
#include "bvh/types.h"
#include "tuning.h"

namespace {

using test::Float3;

// `count` triangles of one size around each point, point by point.
test::Mesh clumps_at(test::Random& random, const std::vector<Float3>& points, uint32_t count) {
    test::Mesh mesh;
    for (const Float3& p : points)
        for (uint32_t i = 0; i < count; ++i) {
            const Float3 at = p + 0.1f * random.direction();
            mesh.add(at, at + Float3(0.02f, 0, 0), at + Float3(0, 0.02f, 0.02f));
        }
    return mesh;
}

// In a row along x, `near` of them and `far` more at some distance.
std::vector<Float3> two_rows(uint32_t near, uint32_t far) {
    std::vector<Float3> points;
    for (uint32_t i = 0; i < near; ++i) points.emplace_back(float(i), 0, 0);
    for (uint32_t i = 0; i < far; ++i) points.emplace_back(200 + float(i), 0, 0);
    return points;
}

std::vector<uint32_t> triangles_of(const bvh_leaf& leaf) {
    std::vector<uint32_t> triangles;
    for (const uint32_t word : leaf.triangle)
        if (word != RSH_NO_HIT) triangles.push_back(RSH_TRIANGLE_INDEX(word));
    return triangles;
}

std::set<uint32_t> clumps_in(const bvh_leaf& leaf, uint32_t count) {
    std::set<uint32_t> clumps;
    for (const uint32_t t : triangles_of(leaf)) clumps.insert(t / count);
    return clumps;
}

// One part, so that nothing else cuts them; and each of the 12 in a cell of its own.
TEST(BoxCuts, SeparateClumps) {
    test::Random random(20);
    for (const uint32_t count : {14u, 15u}) {
        const test::Mesh mesh = clumps_at(random, two_rows(12, 0), count);
        const test::SceneBvh bvh = test::build_bvh(test::DeviceMesh(mesh));
        expect_contained(mesh, bvh);
        for (const bvh_leaf& leaf : bvh.leaves)
            EXPECT_LE(clumps_in(leaf, count).size(), 1u) << "clumps of " << count;
    }
}

TEST(BoxCuts, SeparateNodes) {
    test::Random random(21);
    const uint32_t count = 15, near = 9;
    const test::Mesh mesh = clumps_at(random, two_rows(near, 8), count);
    const test::SceneBvh bvh = test::build_bvh(test::DeviceMesh(mesh));
    uint32_t nodes = 0;
    for (const uint32_t node : bvh.nodes[bvh.top()].child) {
        if (node & RSH_IS_LEAF) continue;
        std::set<bool> sides;
        for (const uint32_t child : bvh.nodes[node].child)
            if (child != RSH_NO_CHILD)
                for (const uint32_t clump :
                     clumps_in(bvh.leaves[RSH_CHILD_NUMBER(child)], count))
                    sides.insert(clump < near);
        EXPECT_EQ(sides.size(), 1u) << "node " << node;
        ++nodes;
    }
    EXPECT_GT(nodes, 0u);
}

struct Sides {
    Float3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};

    void add(const test::Corners& corners) {
        for (const Float3& p : corners) {
            low = Float3(std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z));
            high = Float3(std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z));
        }
    }
    double surface() const {
        const double x = high.x - low.x, y = high.y - low.y, z = high.z - low.z;
        return x * y + y * z + z * x;
    }
};

Sides sides_of(const test::Mesh& mesh, const uint32_t* triangles, size_t count) {
    Sides sides;
    test::Corners corners;
    for (size_t i = 0; i < count; ++i)
        if (mesh.corners(triangles[i], &corners)) sides.add(corners);
    return sides;
}

// The least sum over all cuts into ranges of 8 to 16.
double least_cost(const test::Mesh& mesh, const std::vector<uint32_t>& order,
                  double leaf_cost) {
    std::vector<double> least(order.size() + 1, INFINITY);
    least[0] = 0;
    for (size_t j = 8; j <= order.size(); ++j)
        for (size_t l = 8; l <= std::min<size_t>(16, j); ++l)
            least[j] = std::min(least[j], least[j - l] + leaf_cost +
                                              sides_of(mesh, &order[j - l], l).surface());
    return least.back();
}

// As many as the kernel looks at at once.
TEST(BoxCuts, HaveTheLeastSurface) {
    for (const uint32_t seed : {22u, 23u, 24u, 25u}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        test::Random random(seed);
        const uint32_t count = 150 + random.below(40);
        const test::Mesh mesh = test::random_soup(random, count, 0.1f);
        const test::SceneBvh bvh = test::build_bvh(test::DeviceMesh(mesh));
        const double scene = sides_of(mesh, bvh.order.data(), count).surface();
        const double leaf_cost = RSH_LEAF_COST * scene / (count / RSH_MEAN_RANGE);
        double cost = 0;
        uint32_t leaves = 0;
        for (const bvh_leaf& leaf : bvh.leaves) {
            const std::vector<uint32_t> triangles = triangles_of(leaf);
            if (triangles.empty()) continue;
            cost += leaf_cost + sides_of(mesh, triangles.data(), triangles.size()).surface();
            ++leaves;
        }
        ASSERT_LE(14 * leaves, count + 28) << "there was no room for the best cuts";
        EXPECT_NEAR(cost, least_cost(mesh, bvh.order, leaf_cost), 1e-4 * cost);
    }
}

// Clumps of 9 ask for more leaves than there is room for.
TEST(BoxCuts, FindRoomAtAnySize) {
    test::Random random(26);
    for (const uint32_t size :
         {1u, 7u, 8u, 9u, 15u, 16u, 17u, 31u, 255u, 256u, 257u, 1000u, 4097u, 20001u}) {
        if (test::small() && size > 300) continue;
        SCOPED_TRACE(std::to_string(size) + " triangles");
        std::vector<Float3> points;
        for (uint32_t i = 0; i <= size / 9; ++i)
            points.push_back(40.0f * Float3(random.unit(), random.unit(), random.unit()));
        test::Mesh mesh = clumps_at(random, points, 9);
        mesh.vertices.resize(3 * size);
        const test::DeviceMesh scene(mesh);
        expect_contained(mesh, test::build_bvh(scene));
        expect_contained(mesh, test::kept_bvhs({&scene})[0]);
    }
}

}  // namespace
