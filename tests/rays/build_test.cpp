// build_test.cpp - every stored cone contains every active ray below it; the shape is the one
// that ray_levels describes.
#include <gtest/gtest.h>

#include <tuple>

#include "oracle/containment.hpp"
#include "rays/levels.hpp"
#include "support/cases.hpp"
#include "support/compare.hpp"
#include "support/levels.hpp"
#include "support/trace.hpp"

namespace {

using test::Hierarchy;
using test::Rays;

::testing::AssertionResult contains_its_rays(const oracle::Node& node, const Rays& rays,
                                             const std::vector<size_t>& below) {
    bool active = false;
    for (const size_t i : below) {
        if (!test::is_active(rays.rays[i])) continue;
        active = true;
        if (!oracle::starts_inside(node, rays.rays[i]))
            return ::testing::AssertionFailure()
                   << "ray " << i << " starts outside: " << rays.rays[i];
        if (!oracle::points_inside(node, rays.rays[i]))
            return ::testing::AssertionFailure()
                   << "ray " << i << " points outside: " << rays.rays[i];
    }
    if (active == (node.radius >= 0)) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << (active ? "holds active rays" : "holds none") << ", radius " << node.radius;
}

void expect_contains_all(const Rays& rays) {
    const Hierarchy h = test::build(rays);
    const ray_levels& l = h.levels;
    ASSERT_EQ(h.quads.size(), l.first_child_group[l.count]);
    for (uint32_t level = 0; level < l.count; ++level)
        for (uint32_t parent = 0; parent < l.width[level + 1] * l.height[level + 1]; ++parent)
            for (uint32_t k = 0; k < 4; ++k) {
                const oracle::Node node =
                    oracle::child_of(h.quads[l.first_child_group[level] + parent], k);
                uint32_t x, y;
                std::vector<size_t> below;
                if (test::child_of(l, level, parent, k, &x, &y) >= 0)
                    below = test::rays_below(l, level, x, y);
                ASSERT_TRUE(contains_its_rays(node, rays, below))
                    << "child " << k << " of node " << parent << " of level " << level + 1
                    << ": radius " << node.radius << ", sine " << node.sine;
            }
}

void expect_levels(uint32_t width, uint32_t height) {
    const ray_levels l = rsh::cone_levels(width, height);

    // One column is a list as well: its rays lie in a row.
    const bool is_list = std::min(width, height) <= 1;
    if (is_list && height > 1) std::swap(width, height);
    ASSERT_EQ(l.is_list, is_list ? 1u : 0u);
    ASSERT_EQ(l.width[0], width);
    ASSERT_EQ(l.height[0], std::max(height, 1u));
    ASSERT_LE(l.count, cl_uint(RSH_MAX_LEVELS));
    uint32_t quads = 0;
    for (uint32_t level = 0; level < l.count; ++level) {
        const uint32_t w = l.width[level], h = l.height[level];
        EXPECT_EQ(l.width[level + 1], is_list ? (w + 3) / 4 : (w + 1) / 2) << "level " << level;
        EXPECT_EQ(l.height[level + 1], is_list ? 1 : (h + 1) / 2) << "level " << level;
        EXPECT_EQ(l.first_child_group[level], quads) << "level " << level;
        quads += l.width[level + 1] * l.height[level + 1];
    }
    EXPECT_EQ(l.width[l.count] * l.height[l.count], 1u) << "the root is one node";
    EXPECT_EQ(l.first_child_group[l.count], quads);
}

class Build : public ::testing::TestWithParam<test::NamedCase> {};

TEST_P(Build, ContainsEveryActiveRayBelow) {
    test::Random random(3);
    expect_contains_all(GetParam().make(random).rays);
}

TEST_P(Build, WritesTheSameBytesTwice) {
    test::Random random(3);
    const Rays rays = GetParam().make(random).rays;
    EXPECT_TRUE(test::same_bits(test::build(rays).quads, test::build(rays).quads, "quads"));
}

INSTANTIATE_TEST_SUITE_P(All, Build, ::testing::ValuesIn(test::all_cases()), test::case_name);

TEST(BuildSizes, ContainRaysInGridsOfAnyShape) {
    test::Random random(4);
    const uint32_t shapes[][2] = {{1, 1},  {1, 2},   {2, 1},   {1, 131}, {131, 1}, {3, 3},
                                  {7, 64}, {63, 65}, {64, 64}, {97, 2},  {5, 1},   {4, 1}};
    for (const auto& shape : shapes) {
        SCOPED_TRACE(std::to_string(shape[0]) + " x " + std::to_string(shape[1]));
        expect_contains_all(test::random_rays(random, shape[0], shape[1]));
    }
}

TEST(BuildSizes, ContainNothingWhenNoRayIsActive) {
    Rays rays;
    rays.width = 9, rays.height = 5;
    rays.rays.assign(45, test::inactive_ray());
    expect_contains_all(rays);
}

TEST(BuildQuery, DescribesThePyramidOfAnyGridAndList) {
    for (const uint32_t width : {1u, 2u, 3u, 4u, 5u, 63u, 64u, 65u, 1021u, 16384u})
        for (const uint32_t height : {0u, 1u, 2u, 3u, 4u, 64u, 769u, 16384u}) {
            SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
            expect_levels(width, height);
        }
    expect_levels(1u << 28, 1);
}

}  // namespace
