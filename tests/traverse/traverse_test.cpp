// traverse_test.cpp - paper_faithful equals brute force bit for bit for every case, strategy and
// budget; and what engine_test.cpp does not ask of every way: streams that are full, rays of one
// light, every vector width, ties.
#include <gtest/gtest.h>

#include <tuple>

#include "support/cases.hpp"
#include "support/compare.hpp"
#include "support/strategies.hpp"
#include "support/ways.hpp"
#include "traverse/paper_faithful/types.h"

namespace {

using test::brute_force;
using test::brute_force_and_all_ways;
using test::Case;
using test::DeviceMesh;
using test::TraceOptions;

TraceOptions paper(cl_uint strategy, size_t budget = 0) {
    TraceOptions options;
    options.engine = RSH_ENGINE_PAPER_FAITHFUL;
    options.strategy = strategy;
    options.budget = budget;
    return options;
}

// Other bits must survive, so they start as noise.
std::vector<uint32_t> noise(size_t count, uint32_t bit) {
    test::Random random(7);
    std::vector<uint32_t> masks(count);
    for (uint32_t& mask : masks) mask = uint32_t(random.bits()) & ~(1u << bit);
    return masks;
}

using Param = std::tuple<test::NamedCase, cl_uint>;

class Traverse : public ::testing::TestWithParam<Param> {
protected:
    Case make_case() const {
        test::Random random(8);
        return std::get<0>(GetParam()).make(random);
    }
    cl_uint strategy() const { return std::get<1>(GetParam()); }
};

TEST_P(Traverse, FindsTheHitsOfBruteForce) {
    const Case c = make_case();
    const DeviceMesh mesh(c.mesh);
    const auto expected = closest_hits(mesh, c.rays, brute_force());
    const auto actual = closest_hits(mesh, c.rays, paper(strategy()));
    EXPECT_TRUE(test::same_bits(actual, expected, "hits"));
    EXPECT_TRUE(
        test::same_bits(closest_hits(mesh, c.rays, paper(strategy())), actual, "hits, again"));
}

TEST_P(Traverse, FindsTheOcclusionOfBruteForce) {
    const Case c = make_case();
    const DeviceMesh mesh(c.mesh);
    const auto masks = noise(c.rays.rays.size(), 13);
    const auto hits = closest_hits(mesh, c.rays, brute_force());
    auto expected = masks;
    for (size_t i = 0; i < hits.size(); ++i)
        if (hits[i].primitive != RSH_NO_HIT) expected[i] |= 1u << 13;
    EXPECT_TRUE(test::same_bits(occlusion(mesh, c.rays, masks, 13, brute_force()), expected,
                                "masks of brute force"));
    EXPECT_TRUE(test::same_bits(occlusion(mesh, c.rays, masks, 13, paper(strategy())), expected,
                                "masks"));
}

TEST_P(Traverse, FindsTheSameHitsWithEveryBudget) {
    const Case c = make_case();
    const DeviceMesh mesh(c.mesh);
    const auto expected = closest_hits(mesh, c.rays, brute_force());
    for (const size_t budget : {size_t(RSH_MIN_BUDGET), size_t(RSH_MIN_BUDGET) + 4,
                                size_t(200001), size_t(1) << 22}) {
        TraceOptions options = paper(strategy(), budget);
        options.own_scratch = true;
        options.own_bounds = true;
        EXPECT_TRUE(test::same_bits(closest_hits(mesh, c.rays, options), expected, "hits"))
            << "budget " << budget;
    }
}

std::string name_of(const ::testing::TestParamInfo<Param>& info) {
    return std::get<0>(info.param).name + "_" + test::strategy_name(std::get<1>(info.param));
}

INSTANTIATE_TEST_SUITE_P(All, Traverse,
                         ::testing::Combine(::testing::ValuesIn(test::all_cases()),
                                            ::testing::Values(cl_uint{RSH_STRATEGY_AUTO})),
                         name_of);

// What a strategy can get wrong is the stream's affair, not the scene's.
std::vector<test::NamedCase> some_cases() {
    std::vector<test::NamedCase> some;
    for (const char* name : {"Reflected", "RandomList", "Degenerate"})
        some.push_back(test::case_of_name(name));
    return some;
}

INSTANTIATE_TEST_SUITE_P(EveryStrategy, Traverse,
                         ::testing::Combine(::testing::ValuesIn(some_cases()),
                                            ::testing::ValuesIn(test::all_strategies())),
                         name_of);

// Many triangles that nearly all rays' nodes see, and the least budget: several batches,
// streams that overflow, and still every hit.
void expect_no_pair_lost(TraceOptions options, size_t pair_bytes) {
    test::Random random(9);
    const uint32_t triangles = test::small() ? 3000 : 30000;
    const DeviceMesh mesh(test::random_soup(random, triangles, 0.6f));
    const test::Rays rays = test::random_rays(random, 32, 32);
    const test::OwnContext context;
    RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
    options.context = context.get();
    options.budget = RSH_MIN_BUDGET;
    const auto hits = closest_hits(mesh, rays, options);
    EXPECT_TRUE(test::same_bits(hits, closest_hits(mesh, rays, brute_force()), "hits"));

    rsh_statistics s = {};
    s.struct_size = sizeof s;
    RSH_CHECK(rsh_get_statistics(context.get(), &s));
    cl_ulong walked = 0;
    for (const cl_ulong pairs : s.pairs_walked) walked += pairs;
    EXPECT_GT(walked, 0u) << "the case is too easy: no stream overflowed";
    if (!test::small()) {
        EXPECT_GT(s.batches, 1u);
    }
    EXPECT_EQ(s.traversals, 1u);
    EXPECT_GT(s.node_tests, triangles);
    EXPECT_GT(s.ray_tests, 0u);
    EXPECT_GT(s.peak_pairs, 0u);
    EXPECT_LE(s.peak_pairs * pair_bytes, size_t(RSH_MIN_BUDGET));
}

class Overflow : public ::testing::TestWithParam<cl_uint> {};

TEST_P(Overflow, LosesNoPairWhenStreamsAreFull) {
    expect_no_pair_lost(paper(GetParam()), sizeof(stream_pair));
}

INSTANTIATE_TEST_SUITE_P(All, Overflow, ::testing::ValuesIn(test::all_strategies()),
                         [](const auto& strategy) {
                             return test::strategy_name(strategy.param);
                         });

TEST(OverflowOfRuns, LosesNoPairWhenStreamsAreFull) {
    for (const TraceOptions& way : test::ways_of(RSH_ENGINE_PAPER)) {
        SCOPED_TRACE(name_of(way));
        expect_no_pair_lost(way, sizeof(cl_uint));
    }
}

// Side by side towards a light that lies in the same octant for all: bundles as a renderer makes
// them.
test::Rays shadow_rays(uint32_t side) {
    test::Rays rays{{}, side, side};
    const test::Float3 light(4, 5, 3);
    for (uint32_t i = 0; i < side * side; ++i) {
        const test::Float3 origin(2.0f * float(i % side) / float(side) - 1, -1.5f,
                                  2.0f * float(i / side) / float(side) - 1);
        rays.rays.push_back(test::make_ray(origin, light - origin, 0, 1 - 0x1p-16f));
    }
    return rays;
}

TEST(ConvergingRays, OfOneOctantHitWhatTheyHitByBruteForce) {
    test::Random random(15);
    const DeviceMesh mesh(test::random_soup(random, test::small() ? 300 : 6000, 0.03f));
    const test::Rays rays = shadow_rays(test::small() ? 16 : 80);
    for (TraceOptions options : test::all_ways()) {
        options.converging = true;
        EXPECT_TRUE(test::same_bits(closest_hits(mesh, rays, options),
                                    closest_hits(mesh, rays, brute_force()), "hits"))
            << name_of(options);
        const auto masks = noise(rays.rays.size(), 5);
        EXPECT_TRUE(test::same_bits(occlusion(mesh, rays, masks, 5, options),
                                    occlusion(mesh, rays, masks, 5, brute_force()), "masks"))
            << name_of(options);
    }
}

// Nodes may bound rays from where they meet. Rays that run on behind that point, and rays that
// never were meant to meet, are found all the same.
void expect_converging_as_brute_force(TraceOptions options) {
    SCOPED_TRACE(name_of(options));
    test::Random random(13);
    options.converging = true;
    const uint32_t side = test::small() ? 12 : 61;
    for (const float scale : {1.0f, 1e-9f, 1e9f, 1e18f})
        for (const test::Float3 light : {test::Float3(0.2f, 0.9f, 0.1f), {40, 3, -7}}) {
            const DeviceMesh mesh(scaled(test::random_soup(random, side * 9), scale, {}));
            const test::Rays rays =
                scaled(test::converging_rays(random, side, side, light), scale, {});
            EXPECT_TRUE(test::same_bits(closest_hits(mesh, rays, options),
                                        closest_hits(mesh, rays, brute_force()), "hits"))
                << "scale " << scale;
            const auto masks = noise(rays.rays.size(), 3);
            EXPECT_TRUE(test::same_bits(occlusion(mesh, rays, masks, 3, options),
                                        occlusion(mesh, rays, masks, 3, brute_force()),
                                        "masks"))
                << "scale " << scale;
        }
    const DeviceMesh mesh(test::random_soup(random, 200));
    const test::Rays any = test::random_rays(random, side, 7);
    EXPECT_TRUE(test::same_bits(closest_hits(mesh, any, options),
                                closest_hits(mesh, any, brute_force()), "hits of any rays"));
}

TEST(ConvergingRays, HitWhatTheyHitByBruteForce) {
    for (const TraceOptions& way : test::all_ways()) expect_converging_as_brute_force(way);
}

TEST(ConvergingRays, LeaveFewerPairs) {
    test::Random random(14);
    const DeviceMesh mesh(test::random_soup(random, 2000));
    const test::Rays rays = test::converging_rays(random, 48, 48, {0.2f, 0.9f, 0.1f});
    cl_ulong pairs[2] = {};
    for (const bool converging : {false, true}) {
        const test::OwnContext context;
        RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
        TraceOptions options = paper(0);
        options.context = context.get();
        options.converging = converging;
        closest_hits(mesh, rays, options);
        rsh_statistics s = {};
        s.struct_size = sizeof s;
        RSH_CHECK(rsh_get_statistics(context.get(), &s));
        for (const cl_ulong level : s.pairs_tested) pairs[converging] += level;
    }
    EXPECT_LT(pairs[true], pairs[false]);
}

// Every width is a program of its own.
TEST(TraverseHits, AreTheSameWithEveryVectorWidth) {
    test::Random random(12);
    const DeviceMesh mesh(test::random_soup(random, test::small() ? 50 : 700));
    const test::Rays rays = test::random_rays(random, test::small() ? 8 : 48, 31);
    const auto expected = closest_hits(mesh, rays, brute_force());
    for (const cl_uint width : {1u, 4u, 8u, 16u})
        for (const size_t budget : {size_t(0), size_t(RSH_MIN_BUDGET)}) {
            const test::OwnContext context(width);
            for (TraceOptions options : brute_force_and_all_ways()) {
                options.context = context.get();
                options.budget = budget;
                EXPECT_TRUE(
                    test::same_bits(closest_hits(mesh, rays, options), expected, "hits"))
                    << name_of(options) << ", width " << width << ", budget " << budget;
            }
        }
}

TEST(TraverseHits, OfRaysThatHitNothingHoldTmaxAndZeros) {
    const Case c = {test::sphere(8, 5), [] {
                        test::Rays rays = test::pinhole_rays(9, 9, {0, 0, 5}, {0, 0, 9});
                        for (rsh_ray& ray : rays.rays) ray.direction_tmax.s[3] = 7.25f;
                        return rays;
                    }()};
    for (const TraceOptions& options : brute_force_and_all_ways())
        for (const rsh_hit& hit : closest_hits(DeviceMesh(c.mesh), c.rays, options)) {
            ASSERT_EQ(hit.primitive, RSH_NO_HIT);
            ASSERT_EQ(hit.t, 7.25f);
            ASSERT_EQ(hit.u, 0);
            ASSERT_EQ(hit.v, 0);
        }
}

TEST(TraverseHits, OfEqualTNameTheLowerTriangle) {
    test::Random random(10);
    const test::Mesh once = test::random_soup(random, 100, 0.8f);
    test::Mesh thrice;
    for (int copy = 0; copy < 3; ++copy)
        thrice.vertices.insert(thrice.vertices.end(), once.vertices.begin(),
                               once.vertices.end());
    const test::Rays rays = test::random_rays(random, 64, 32);
    for (const TraceOptions& options : brute_force_and_all_ways())
        EXPECT_TRUE(test::same_bits(closest_hits(DeviceMesh(thrice), rays, options),
                                    closest_hits(DeviceMesh(once), rays, brute_force()),
                                    "hits"));
}

TEST(TraverseHits, NeverNameATriangleWithTwoEqualCorners) {
    test::Random random(11);
    test::Mesh mesh;
    for (int i = 0; i < 200; ++i) {
        const test::Float3 a = random.in_cube(), b = random.in_cube();
        mesh.add(a, i % 2 ? a : b, i % 3 ? b : a);
    }
    const test::Rays rays = test::rays_at_edges(random, mesh, 40, 40);
    for (const TraceOptions& options : test::all_ways())
        for (const rsh_hit& hit : closest_hits(DeviceMesh(mesh), rays, options))
            ASSERT_EQ(hit.primitive, RSH_NO_HIT);
}

}  // namespace
