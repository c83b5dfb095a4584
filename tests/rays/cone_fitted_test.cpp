// cone_fitted_test.cpp - every node of the bound `cone_fitted` contains every active ray below
// it, seen from its origin or, converging, from t = 1 backwards; and is no looser than its
// children need.
#include <gtest/gtest.h>

#include "oracle/containment.hpp"
#include "rays/types.h"
#include "support/cases.hpp"
#include "support/compare.hpp"
#include "support/levels.hpp"
#include "support/trace.hpp"

namespace {

using test::Float3;
using test::Long3;
using test::Rays;

bool ends_at_one(const rsh_ray& ray) {
    return ray.direction_tmax.s[3] <= 1 && finite(test::origin(ray) + test::direction(ray));
}

::testing::AssertionResult contains(const oracle::FittedNode& node, const rsh_ray& ray,
                                    bool converging) {
    const Float3 d = test::direction(ray);
    const Long3 origin(test::origin(ray));
    const bool is_inside =
        !converging        ? oracle::contains(node, origin, d)
        : ends_at_one(ray) ? oracle::contains(node, origin + Long3(d), Float3(-d.x, -d.y, -d.z))
                           : node.spread == 2 && oracle::contains(node, origin, d);
    if (is_inside) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "ray is outside: " << ray << ", radius "
                                         << node.radius << ", spread " << node.spread;
}

::testing::AssertionResult contains_its_rays(const oracle::FittedNode& node, const Rays& rays,
                                             const std::vector<size_t>& below,
                                             bool converging) {
    bool active = false;
    for (const size_t i : below) {
        if (!test::is_active(rays.rays[i])) continue;
        active = true;
        const auto result = contains(node, rays.rays[i], converging);
        if (!result) return result;
    }
    if (active == (node.radius >= 0)) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << (active ? "holds active rays" : "holds none") << ", radius " << node.radius;
}

void expect_contains_all(const Rays& rays, bool converging) {
    const auto built = test::build_nodes(rays, RSH_BOUND_CONE_FITTED, converging);
    const auto groups = test::nodes_of<rsh_cone_group>(built);
    const rsh_levels& l = built.levels;
    ASSERT_EQ(l.width[l.count] * l.height[l.count], 1u) << "the root is one node";
    ASSERT_EQ(groups.size(), l.first_quad[l.count]);
    for (uint32_t level = 1; level < l.count; ++level)
        for (uint32_t parent = 0; parent < l.width[level + 1] * l.height[level + 1]; ++parent)
            for (uint32_t k = 0; k < 16; ++k) {
                uint32_t x, y;
                std::vector<size_t> below;
                if (test::child_of(l, level, parent, k, &x, &y) >= 0)
                    below = test::rays_below(l, level, x, y);
                ASSERT_TRUE(
                    contains_its_rays(oracle::child_of(groups[l.first_quad[level] + parent], k),
                                      rays, below, converging))
                    << "child " << k << " of node " << parent << " of level " << level + 1;
            }
}

class ConeFitted : public ::testing::TestWithParam<test::NamedCase> {};

TEST_P(ConeFitted, ContainsEveryActiveRayBelow) {
    test::Random random(3);
    const Rays rays = GetParam().make(random).rays;
    for (const bool converging : {false, true}) {
        SCOPED_TRACE(converging ? "converging" : "from the origins");
        expect_contains_all(rays, converging);
    }
}

INSTANTIATE_TEST_SUITE_P(All, ConeFitted, ::testing::ValuesIn(test::all_cases()),
                         test::case_name);

TEST(ConeFittedSizes, ContainRaysInGridsOfAnyShape) {
    test::Random random(4);
    const uint32_t shapes[][2] = {{1, 1},  {2, 1},   {1, 131},  {257, 1},
                                  {17, 3}, {64, 65}, {259, 16}, {4099, 1}};
    for (const auto& shape : shapes) {
        SCOPED_TRACE(std::to_string(shape[0]) + " x " + std::to_string(shape[1]));
        expect_contains_all(test::random_rays(random, shape[0], shape[1]), false);
    }
    expect_contains_all(test::pinhole_rays(300, 70), false);
    expect_contains_all(test::converging_rays(random, 81, 67, {0.2f, 0.9f, 0.1f}), true);
}

// Parallel rays leave no angle to any node, however many there are below it; the sphere is the
// half diagonal of their origins.
TEST(ConeFittedTightness, IsThatOfTheRaysAtEveryLevel) {
    Rays rays{{}, 96, 96};
    for (uint32_t i = 0; i < 96 * 96; ++i)
        rays.rays.push_back(
            test::make_ray(Float3(float(i % 96), float(i / 96), 0), Float3(1, 2, 3)));
    const auto built = test::build_nodes(rays, RSH_BOUND_CONE_FITTED, false);
    const auto groups = test::nodes_of<rsh_cone_group>(built);
    const rsh_levels& l = built.levels;
    for (uint32_t level = 1; level < l.count; ++level) {
        const float half = 0.5f * float(std::min<uint64_t>(test::side_of(l, level), 96) - 1);
        const rsh_cone_group& group = groups[l.first_quad[level]];
        EXPECT_LE(group.spread[0], 0x1p-17f) << "level " << level;
        EXPECT_LE(group.radius[0], 1.4143f * half * 1.0001f) << "level " << level;
    }
}

}  // namespace
