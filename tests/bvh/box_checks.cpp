#include "bvh/box_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "bvh/types.h"
#include "oracle/containment.hpp"
#include "rays/types.h"
#include "support/compare.hpp"
#include "support/levels.hpp"

namespace {

using test::Float3;
using test::Long3;
using test::Rays;

// rays/box_node.h pads by 64u of the largest component; rounding may take a few of them away.
constexpr long double kPad = 0x3cp-24L;

bool ends_at_one(const rsh_ray& ray) {
    return ray.direction_tmax.s[3] <= 1 && finite(test::origin(ray) + test::direction(ray));
}

bool contains(const oracle::BoxNode& node, const rsh_ray& ray, bool converging) {
    const Float3 o = test::origin(ray), d = test::direction(ray);
    const float tmax = ray.direction_tmax.s[3];
    if (!converging)
        return node.tmax >= tmax && oracle::contains(node, Long3(o), kPad * max_norm(o), d);
    if (!ends_at_one(ray))  // anywhere, in any direction
        return std::isinf(node.origin_high.x) && std::isinf(node.direction_low.z) &&
               oracle::contains(node, Long3(o), 0, d);
    return node.tmax >= 1 && oracle::contains(node, Long3(o) + Long3(d), kPad * max_norm(o),
                                              Float3(-d.x, -d.y, -d.z));
}

bool is_empty(const bvh_node& node, uint32_t k) {
    for (int axis = 0; axis < 3; ++axis)
        if (node.low[axis][k] != INFINITY || node.high[axis][k] != -INFINITY) return false;
    return true;
}

// Corners of the triangle in place k; false if it is never hit.
bool corners_of(const bvh_leaf& leaf, uint32_t k, test::Corners* corners) {
    for (int i = 0; i < 3; ++i)
        (*corners)[i] = {leaf.corner[i][0][k], leaf.corner[i][1][k], leaf.corner[i][2][k]};
    return finite((*corners)[0]) && finite((*corners)[1]) && finite((*corners)[2]);
}

auto key(const Float3& v) {
    return std::make_tuple(v.x, v.y, v.z);
}

// By x, then y, then z.
test::Corners in_order(test::Corners c) {
    std::sort(c.begin(), c.end(),
              [](const Float3& a, const Float3& b) { return key(a) < key(b); });
    return c;
}

// Whether `places` say where the given corners 1 and 2 went.
bool are_places(uint32_t places, const test::Corners& given, const test::Corners& ordered) {
    const uint32_t one = places % 4, two = places / 4;
    return one < 3 && two < 3 && one != two && key(ordered[one]) == key(given[1]) &&
           key(ordered[two]) == key(given[2]);
}

bool is_hit(const test::Mesh& mesh, uint32_t triangle, test::Corners* corners) {
    return triangle < mesh.triangle_count() && mesh.corners(triangle, corners) &&
           finite((*corners)[0]) && finite((*corners)[1]) && finite((*corners)[2]);
}

// In order, or at infinity where the triangle is never hit. word: of the leaf, or RSH_NO_HIT.
::testing::AssertionResult is_triangle(const bvh_leaf& leaf, uint32_t k, const test::Mesh& mesh,
                                       uint32_t word) {
    const Float3 nowhere(INFINITY, INFINITY, INFINITY);
    test::Corners given, stored;
    corners_of(leaf, k, &stored);
    const bool is_seen = word != RSH_NO_HIT && is_hit(mesh, RSH_TRIANGLE_INDEX(word), &given);
    const test::Corners expected =
        is_seen ? in_order(given) : test::Corners{nowhere, nowhere, nowhere};
    for (int i = 0; i < 3; ++i)
        if (key(stored[i]) != key(expected[i]))
            return ::testing::AssertionFailure()
                   << "triangle " << RSH_TRIANGLE_INDEX(word) << ", corner " << i << ": "
                   << ::testing::PrintToString(key(stored[i])) << " instead of "
                   << ::testing::PrintToString(key(expected[i]));
    if (is_seen && !are_places(RSH_TRIANGLE_PLACES(word), given, stored))
        return ::testing::AssertionFailure() << "triangle " << RSH_TRIANGLE_INDEX(word)
                                             << ": places " << RSH_TRIANGLE_PLACES(word);
    return ::testing::AssertionSuccess();
}

// The triangles, padded.
::testing::AssertionResult holds_leaf(const bvh_node& above, uint32_t k, const bvh_leaf& leaf) {
    for (uint32_t t = 0; t < 16; ++t) {
        test::Corners c;
        if (!corners_of(leaf, t, &c)) continue;
        for (const Float3& p : c) {
            const long double pad = kPad * max_norm(p);
            const float at[3] = {p.x, p.y, p.z};
            for (int axis = 0; axis < 3; ++axis)
                if (!(above.low[axis][k] <= at[axis] - pad &&
                      above.high[axis][k] >= at[axis] + pad))
                    return ::testing::AssertionFailure()
                           << "place " << t << ", axis " << axis << ": " << at[axis]
                           << " is not inside " << above.low[axis][k] << " .. "
                           << above.high[axis][k];
        }
    }
    return ::testing::AssertionSuccess();
}

// Outside of the sizes that mesh/intersect.h takes as they are.
bool is_scaled(const bvh_leaf& leaf) {
    for (uint32_t t = 0; t < 16; ++t) {
        test::Corners c;
        if (!corners_of(leaf, t, &c)) continue;
        const float size = std::max(max_norm(c[1] - c[0]), max_norm(c[2] - c[0]));
        if (!(size >= 0x1p-20f && size <= 0x1p20f)) return true;
    }
    return false;
}

bool holds_node(const bvh_node& above, uint32_t k, const bvh_node& child) {
    for (int axis = 0; axis < 3; ++axis)
        for (uint32_t b = 0; b < 16; ++b)
            if (!(above.low[axis][k] <= child.low[axis][b] &&
                  above.high[axis][k] >= child.high[axis][b]))
                return false;
    return true;
}

// What is below each box of a node, and so on; marks nodes and leaves.
class Walk {
public:
    Walk(const test::Mesh& mesh, const test::SceneBvh& bvh) : mesh_(mesh), bvh_(bvh) {}

    void check_node(uint32_t number, uint32_t depth) {
        ASSERT_LE(depth, uint32_t{RSH_MAX_BVH_DEPTH});
        ASSERT_LT(number, bvh_.nodes.size());
        ASSERT_TRUE(nodes_.insert(number).second) << "node " << number << " twice";
        const bvh_node& node = bvh_.nodes[number];
        for (uint32_t k = 0; k < 16; ++k) {
            SCOPED_TRACE("node " + std::to_string(number) + ", box " + std::to_string(k));
            if (node.child[k] == RSH_NO_CHILD) {
                ASSERT_TRUE(is_empty(node, k));
            } else if (node.child[k] & RSH_IS_LEAF) {
                check_leaf(node, k);
            } else {
                ASSERT_LT(node.child[k], bvh_.nodes.size());
                ASSERT_TRUE(holds_node(node, k, bvh_.nodes[node.child[k]]));
                check_node(node.child[k], depth + 1);
            }
            if (::testing::Test::HasFatalFailure()) return;
        }
    }

    BvhCounts counts() const { return {leaves_.size(), nodes_.size()}; }

    // In the order of the leaves.
    std::vector<uint32_t> order() const {
        std::vector<uint32_t> order;
        for (const uint32_t number : leaves_)
            for (const uint32_t word : bvh_.leaves[number].triangle)
                if (word != RSH_NO_HIT) order.push_back(RSH_TRIANGLE_INDEX(word));
        return order;
    }

    // Those that no node names.
    void expect_others_empty() const {
        for (uint32_t c = 0; c < bvh_.leaves.size(); ++c) {
            if (leaves_.count(c)) continue;
            for (uint32_t k = 0; k < 16; ++k)
                ASSERT_TRUE(is_triangle(bvh_.leaves[c], k, mesh_, RSH_NO_HIT));
        }
    }

private:
    void check_leaf(const bvh_node& node, uint32_t k) {
        const uint32_t number = RSH_CHILD_NUMBER(node.child[k]);
        ASSERT_LT(number, bvh_.leaves.size());
        ASSERT_TRUE(leaves_.insert(number).second) << "leaf " << number << " twice";
        const bvh_leaf& leaf = bvh_.leaves[number];
        EXPECT_EQ((node.child[k] & RSH_SCALED) != 0, is_scaled(leaf));
        ASSERT_TRUE(holds_leaf(node, k, leaf));
        for (uint32_t i = 0; i < 16; ++i)
            ASSERT_TRUE(is_triangle(leaf, i, mesh_, leaf.triangle[i])) << "place " << i;
    }

    const test::Mesh& mesh_;
    const test::SceneBvh& bvh_;
    std::set<uint32_t> nodes_, leaves_;
};

}  // namespace

void expect_permutation(std::vector<uint32_t> numbers) {
    std::sort(numbers.begin(), numbers.end());
    for (uint32_t i = 0; i < numbers.size(); ++i) ASSERT_EQ(numbers[i], i);
}

void expect_contains_all(const Rays& rays, bool converging) {
    const auto built = test::build_nodes(rays, RSH_SHAPE_BOX, converging);
    const auto tiles = test::nodes_of<box_node16>(built);
    const ray_levels& l = built.levels;
    ASSERT_EQ(l.count, 2u);
    const test::RayOrder order = test::ray_order(built);
    expect_permutation(order.rays);
    for (uint32_t tile = 0; tile < l.width[2] * l.height[2]; ++tile)
        for (uint32_t k = 0; k < 16; ++k) {
            const oracle::BoxNode node = oracle::child_of(tiles[tile], k);
            EXPECT_EQ(tiles[tile].is_converging[k], uint32_t(converging));
            uint32_t x, y;
            bool active = false;
            if (test::child_of(l, 1, tile, k, &x, &y) >= 0)
                for (const size_t place : test::rays_below(l, 1, x, y)) {
                    const uint32_t i = order.rays[place];
                    if (!test::is_active(rays.rays[i])) continue;
                    active = true;
                    ASSERT_TRUE(contains(node, rays.rays[i], converging))
                        << "ray " << i << " of block " << k << " of tile " << tile << ": "
                        << rays.rays[i];
                }
            ASSERT_TRUE(active || node.tmax < 0)
                << "block " << k << " of tile " << tile << ", tmax " << node.tmax;
        }
}

void expect_contained(const test::Mesh& mesh, const test::SceneBvh& bvh, BvhCounts* counts) {
    expect_permutation(bvh.order);
    if (mesh.triangle_count() == 0) return;
    Walk walk(mesh, bvh);
    walk.check_node(bvh.top(), 1);
    if (::testing::Test::HasFatalFailure()) return;
    EXPECT_EQ(walk.order(), bvh.order);
    walk.expect_others_empty();
    if (counts) *counts = walk.counts();
}
