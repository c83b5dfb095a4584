// box_test.cpp - the bound `box`: every block contains its active rays, with the room that box.h
// asks for around their origins; every box of the scene contains its triangle or the boxes of
// its group.
#include <gtest/gtest.h>

#include <algorithm>

#include "../oracle/containment.hpp"
#include "../support/cases.hpp"
#include "../support/compare.hpp"
#include "../support/levels.hpp"
#include "../support/trace.hpp"

namespace {

using test::Float3;
using test::Long3;
using test::Rays;

// box.h pads by 64u of the largest component; rounding may take a few of them away.
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

void expect_contains_all(const Rays& rays, bool converging) {
    const auto built = test::build_nodes(rays, RSH_BOUND_BOX, converging);
    const auto groups = test::nodes_of<rsh_node_group>(built);
    const rsh_levels& l = built.levels;
    ASSERT_EQ(l.count, 2u);
    ASSERT_EQ(groups.size(), size_t(l.width[2]) * l.height[2]);
    for (uint32_t tile = 0; tile < groups.size(); ++tile)
        for (uint32_t k = 0; k < 16; ++k) {
            const oracle::BoxNode node = oracle::child_of(groups[tile], k);
            EXPECT_EQ(groups[tile].is_converging[k], uint32_t(converging));
            uint32_t x, y;
            bool active = false;
            if (test::child_of(l, 1, tile, k, &x, &y) >= 0)
                for (const size_t i : test::rays_below(l, 1, x, y)) {
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

class Box : public ::testing::TestWithParam<test::NamedCase> {};

TEST_P(Box, ContainsEveryActiveRay) {
    test::Random random(3);
    const Rays rays = GetParam().make(random).rays;
    for (const bool converging : {false, true}) {
        SCOPED_TRACE(converging ? "converging" : "from the origins");
        expect_contains_all(rays, converging);
    }
}

bool is_empty(const rsh_box_group& group, uint32_t k) {
    for (int axis = 0; axis < 3; ++axis)
        if (group.low[axis][k] != INFINITY || group.high[axis][k] != -INFINITY) return false;
    return true;
}

// The padded triangle, or whether the box is empty where there is none to hit.
::testing::AssertionResult holds_triangle(const rsh_box_group& group, uint32_t k,
                                          const test::Mesh& mesh, uint32_t t) {
    test::Corners c;
    const bool is_hit = t < mesh.triangle_count() && mesh.corners(t, &c) && finite(c[0]) &&
                        finite(c[1]) && finite(c[2]);
    if (!is_hit)
        return (is_empty(group, k) ? ::testing::AssertionSuccess()
                                   : ::testing::AssertionFailure())
               << "triangle " << t << " is never hit";
    for (const Float3& p : c) {
        const long double pad = kPad * max_norm(p);
        const float at[3] = {p.x, p.y, p.z};
        for (int axis = 0; axis < 3; ++axis)
            if (!(group.low[axis][k] <= at[axis] - pad &&
                  group.high[axis][k] >= at[axis] + pad))
                return ::testing::AssertionFailure()
                       << "triangle " << t << ", axis " << axis << ": " << at[axis]
                       << " is not inside " << group.low[axis][k] << " .. "
                       << group.high[axis][k];
    }
    return ::testing::AssertionSuccess();
}

bool holds_group(const rsh_box_group& above, uint32_t k, const rsh_box_group& below) {
    for (int axis = 0; axis < 3; ++axis)
        for (uint32_t b = 0; b < 16; ++b)
            if (!(above.low[axis][k] <= below.low[axis][b] &&
                  above.high[axis][k] >= below.high[axis][b]))
                return false;
    return true;
}

void expect_permutation(std::vector<uint32_t> numbers) {
    std::sort(numbers.begin(), numbers.end());
    for (uint32_t i = 0; i < numbers.size(); ++i) ASSERT_EQ(numbers[i], i);
}

// Levels one after the other, each with the groups of the one below in its boxes; those of
// clusters have their children where `children` says.
void expect_contained(const test::Mesh& mesh, const test::SceneBoxes& boxes) {
    const auto& groups = boxes.groups;
    expect_permutation(boxes.children);
    expect_permutation(boxes.order);
    uint32_t below = (mesh.triangle_count() + 15) / 16, first = 0;
    for (uint32_t i = 0; i < 16 * below; ++i) {
        const uint32_t t = i < boxes.order.size() ? boxes.order[i] : i;
        ASSERT_TRUE(holds_triangle(groups[i / 16], i % 16, mesh, t));
    }
    for (uint32_t boxes_here = below; boxes_here > 0; boxes_here = below) {
        const uint32_t level = first + boxes_here;  // where its groups begin
        below = (boxes_here + 15) / 16;
        ASSERT_LE(level + below, groups.size());
        for (uint32_t i = 0; i < 16 * below; ++i) {
            const rsh_box_group& group = groups[level + i / 16];
            if (i >= boxes_here) {
                ASSERT_TRUE(is_empty(group, i % 16)) << "box " << i;
                continue;
            }
            const uint32_t child = first ? first + i : boxes.children[i];
            ASSERT_TRUE(holds_group(group, i % 16, groups[child])) << "box " << i;
        }
        first = level;
        if (below == 1) break;
    }
}

TEST_P(Box, OfTheSceneContainsWhatIsBelowIt) {
    test::Random random(5);
    const test::Mesh mesh = GetParam().make(random).mesh;
    expect_contained(mesh, test::bound_boxes(test::DeviceMesh(mesh)));
}

INSTANTIATE_TEST_SUITE_P(All, Box, ::testing::ValuesIn(test::all_cases()), test::case_name);

// Neighbours in the index that are none in space: the triangles are ordered, and only then.
TEST(BoxOrder, IsThatOfTrianglesWhereRunsOfThemAreSparse) {
    test::Random random(6);
    const uint32_t triangles = test::small() ? 600 : 20000;
    const test::Mesh strewn = test::random_soup(random, triangles, 0.01f);
    const test::SceneBoxes of_strewn = test::bound_boxes(test::DeviceMesh(strewn));
    EXPECT_TRUE(of_strewn.is_ordered);
    expect_contained(strewn, of_strewn);
    const test::Mesh closed = test::sphere(test::small() ? 24 : 160, 81);
    const test::SceneBoxes of_closed = test::bound_boxes(test::DeviceMesh(closed));
    EXPECT_FALSE(of_closed.is_ordered);
    expect_contained(closed, of_closed);
}

TEST(BoxSizes, ContainRaysInGridsOfAnyShape) {
    test::Random random(4);
    const uint32_t shapes[][2] = {{1, 1}, {2, 1}, {1, 131}, {257, 1}, {17, 3}, {64, 65}};
    for (const auto& shape : shapes) {
        SCOPED_TRACE(std::to_string(shape[0]) + " x " + std::to_string(shape[1]));
        expect_contains_all(test::random_rays(random, shape[0], shape[1]), false);
    }
    expect_contains_all(test::converging_rays(random, 61, 47, {0.2f, 0.9f, 0.1f}), true);
}

}  // namespace
