// engine_test.cpp - the hierarchy only leaves out work, never an answer: every engine, with every
// bound that it takes, equals brute force bit for bit, for every case, query, budget and
// direction of bounding, every time.
#include <gtest/gtest.h>

#include "support/cases.hpp"
#include "support/compare.hpp"
#include "support/ways.hpp"

namespace {

using test::brute_force;
using test::Case;
using test::DeviceMesh;
using test::TraceOptions;

class Engine : public ::testing::TestWithParam<test::NamedCase> {
protected:
    Case make_case() const {
        test::Random random(8);
        return GetParam().make(random);
    }
};

TEST_P(Engine, FindsTheHitsOfBruteForce) {
    const Case c = make_case();
    const DeviceMesh mesh(c.mesh);
    const auto expected = closest_hits(mesh, c.rays, brute_force());
    for (TraceOptions way : test::all_ways()) {
        SCOPED_TRACE(name_of(way));
        const auto actual = closest_hits(mesh, c.rays, way);
        EXPECT_TRUE(test::same_bits(actual, expected, "hits"));
        way.own_bounds = way.own_scratch = true;
        EXPECT_TRUE(test::same_bits(closest_hits(mesh, c.rays, way), actual, "hits, again"));
    }
}

TEST_P(Engine, FindsTheOcclusionOfBruteForce) {
    const Case c = make_case();
    const DeviceMesh mesh(c.mesh);
    const std::vector<uint32_t> masks(c.rays.rays.size(), 0xa5a50000u);
    const auto expected = occlusion(mesh, c.rays, masks, 13, brute_force());
    for (const TraceOptions& way : test::all_ways())
        EXPECT_TRUE(test::same_bits(occlusion(mesh, c.rays, masks, 13, way), expected, "masks"))
            << name_of(way);
}

// Bounds from t = 1 backwards enclose the same rays, whatever the rays are.
TEST_P(Engine, FindsTheSameWhenRaysCountAsConverging) {
    const Case c = make_case();
    const DeviceMesh mesh(c.mesh);
    const std::vector<uint32_t> masks(c.rays.rays.size(), 0);
    const auto hits = closest_hits(mesh, c.rays, brute_force());
    const auto occluded = occlusion(mesh, c.rays, masks, 0, brute_force());
    for (TraceOptions way : test::all_ways()) {
        SCOPED_TRACE(name_of(way));
        way.converging = true;
        EXPECT_TRUE(test::same_bits(closest_hits(mesh, c.rays, way), hits, "hits"));
        EXPECT_TRUE(test::same_bits(occlusion(mesh, c.rays, masks, 0, way), occluded, "masks"));
    }
}

// traverse/paper_faithful/traverse_level.cpp gives paper_faithful more budgets, and every strategy.
TEST_P(Engine, FindsTheSameHitsWithEveryBudget) {
    const Case c = make_case();
    const DeviceMesh mesh(c.mesh);
    const auto expected = closest_hits(mesh, c.rays, brute_force());
    for (TraceOptions way : test::all_ways()) {
        if (way.engine == RSH_ENGINE_PAPER_FAITHFUL) continue;
        SCOPED_TRACE(name_of(way));
        way.own_bounds = way.own_scratch = true;
        for (const size_t budget :
             {size_t(RSH_MIN_BUDGET), size_t(RSH_MIN_BUDGET) + 7, size_t(200001)}) {
            way.budget = budget;
            EXPECT_TRUE(test::same_bits(closest_hits(mesh, c.rays, way), expected, "hits"))
                << "budget " << budget;
        }
    }
}

// Whether the order of the earlier frame serves or not.
TEST_P(Engine, FindsTheHitsOfBruteForceAfterAnUpdate) {
    const Case c = make_case();
    test::Random random(16);
    test::Mesh moved = c.mesh;
    for (test::Float3& v : moved.vertices) v = v + 0.01f * max_norm(v) * random.direction();
    const DeviceMesh then(c.mesh), now(moved);
    TraceOptions way;
    way.engine = RSH_ENGINE_TILES;
    way.own_bounds = true;
    way.earlier = {&then};
    EXPECT_TRUE(test::same_bits(closest_hits(now, c.rays, way),
                                closest_hits(now, c.rays, brute_force()), "hits"));
}

INSTANTIATE_TEST_SUITE_P(All, Engine, ::testing::ValuesIn(test::all_cases()), test::case_name);

}  // namespace
