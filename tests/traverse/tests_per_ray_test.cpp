// tests_per_ray_test.cpp - rsh_traverse_desc::tests_per_ray: no answer depends on it, and it grows by what
// a ray was tested against.
#include <gtest/gtest.h>

#include "support/compare.hpp"
#include "support/ways.hpp"

namespace {

using test::DeviceMesh;
using test::Rays;
using test::TraceOptions;

class TestsPerRay : public ::testing::TestWithParam<cl_uint> {
protected:
    std::vector<uint32_t> counted(const Rays& rays, uint32_t before = 0) {
        const test::Buffer<uint32_t> tests(std::vector<uint32_t>(rays.rays.size(), before));
        TraceOptions options;
        options.engine = GetParam();
        const auto expected = closest_hits(mesh_, rays, options);
        options.tests_per_ray = tests.get();
        EXPECT_TRUE(test::same_bits(closest_hits(mesh_, rays, options), expected, "hits"));
        EXPECT_TRUE(tests.guards_intact());
        return tests.read();
    }

    bool is_brute_force() const { return GetParam() == RSH_ENGINE_BRUTE_FORCE; }

    test::Random random_{51};
    const test::Mesh host_ = test::random_soup(random_, test::small() ? 40 : 700, 0.3f);
    const DeviceMesh mesh_{host_};
};

TEST_P(TestsPerRay, GrowOfActiveRaysAlone) {
    const uint32_t width = test::small() ? 20 : 67, height = test::small() ? 5 : 41;
    Rays rays = test::pinhole_rays(width, height);
    for (size_t i = 0; i < rays.rays.size(); i += 7) rays.rays[i].direction_tmax.s[3] = -1;
    const auto tests = counted(rays, 5);
    TraceOptions options;
    options.engine = GetParam();
    const auto hits = closest_hits(mesh_, rays, options);
    for (size_t i = 0; i < tests.size(); ++i) {
        SCOPED_TRACE("ray " + std::to_string(i));
        const uint32_t grown = tests[i] - 5;
        if (i % 7 == 0) {
            EXPECT_EQ(grown, 0u);
        } else if (is_brute_force()) {
            EXPECT_EQ(grown, mesh_.geometry().triangle_count);
        } else if (hits[i].primitive != RSH_NO_HIT) {
            EXPECT_GE(grown, 17u) << "a node's boxes and a triangle";
        }
    }
}

// A ray on its own takes part in all that statistics count, but for the tests of sixteen blocks, fifteen of
// which are none of its.
TEST_P(TestsPerRay, OfALonelyRayAreThoseOfStatistics) {
    if (is_brute_force()) return;  // whose statistics count no tests
    const test::OwnContext context;
    for (int i = 0; i < (test::small() ? 4 : 100); ++i) {
        Rays rays = test::random_rays(random_, 200, 1);
        for (size_t k = 0; k < rays.rays.size(); ++k)
            if (k != size_t(i)) rays.rays[k].direction_tmax.s[3] = -1;
        const uint32_t tests = counted(rays)[size_t(i)];
        TraceOptions options;
        options.engine = GetParam();
        options.context = context.get();
        const rsh_statistics s = statistics_of(mesh_, rays, options);
        const cl_ulong all = s.node_tests + s.ray_tests;
        EXPECT_LE(tests, all) << "ray " << i;
        EXPECT_GE(16 * cl_ulong{tests}, all) << "ray " << i;
    }
}

TEST_P(TestsPerRay, BehindTheEndOfAListStayAsTheyAre) {
    const Rays rays = test::random_rays(random_, test::small() ? 50 : 900, 1);
    const test::Buffer<uint32_t> tests(std::vector<uint32_t>(rays.rays.size(), 9));
    TraceOptions options;
    options.engine = GetParam();
    options.tests_per_ray = tests.get();
    options.list_count = 33;
    closest_hits(mesh_, rays, options);
    const auto grown = tests.read();
    for (size_t i = 33; i < grown.size(); ++i) EXPECT_EQ(grown[i], 9u) << "ray " << i;
}

INSTANTIATE_TEST_SUITE_P(All, TestsPerRay,
                         ::testing::Values(RSH_ENGINE_TILES, RSH_ENGINE_BRUTE_FORCE),
                         [](const auto& engine) {
                             return engine.param == RSH_ENGINE_TILES ? "tiles" : "brute_force";
                         });

}  // namespace
