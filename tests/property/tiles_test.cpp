// tiles_test.cpp - a tile stops early and never too early: the engine `tiles` equals brute force
// bit for bit, for every case, query and direction of bounding, every time.
#include <gtest/gtest.h>

#include "../support/cases.hpp"
#include "../support/compare.hpp"
#include "../support/trace.hpp"

namespace {

using test::Case;
using test::DeviceMesh;
using test::TraceOptions;

TraceOptions with_engine(cl_uint engine) {
    TraceOptions options;
    options.engine = engine;
    return options;
}

class Tiles : public ::testing::TestWithParam<test::NamedCase> {
protected:
    Case make_case() const {
        test::Random random(8);
        return GetParam().make(random);
    }
};

TEST_P(Tiles, FindsTheHitsOfBruteForce) {
    const Case c = make_case();
    const DeviceMesh mesh(c.mesh);
    const auto expected = closest_hits(mesh, c.rays, with_engine(RSH_ENGINE_BRUTE_FORCE));
    TraceOptions options = with_engine(RSH_ENGINE_TILES);
    const auto actual = closest_hits(mesh, c.rays, options);
    EXPECT_TRUE(test::same_bits(actual, expected, "hits"));
    options.own_bounds = options.own_scratch = true;
    EXPECT_TRUE(test::same_bits(closest_hits(mesh, c.rays, options), actual, "hits, again"));
}

TEST_P(Tiles, FindsTheOcclusionOfBruteForce) {
    const Case c = make_case();
    const DeviceMesh mesh(c.mesh);
    const std::vector<uint32_t> masks(c.rays.rays.size(), 0xa5a50000u);
    const auto expected =
        occlusion(mesh, c.rays, masks, 13, with_engine(RSH_ENGINE_BRUTE_FORCE));
    EXPECT_TRUE(test::same_bits(
        occlusion(mesh, c.rays, masks, 13, with_engine(RSH_ENGINE_TILES)), expected, "masks"));
}

// Bounds from t = 1 backwards enclose the same rays, whatever the rays are.
TEST_P(Tiles, FindsTheSameWhenRaysCountAsConverging) {
    const Case c = make_case();
    const DeviceMesh mesh(c.mesh);
    TraceOptions options = with_engine(RSH_ENGINE_TILES);
    options.converging = true;
    EXPECT_TRUE(test::same_bits(closest_hits(mesh, c.rays, options),
                                closest_hits(mesh, c.rays, with_engine(RSH_ENGINE_BRUTE_FORCE)),
                                "hits"));
    const std::vector<uint32_t> masks(c.rays.rays.size(), 0);
    EXPECT_TRUE(test::same_bits(
        occlusion(mesh, c.rays, masks, 0, options),
        occlusion(mesh, c.rays, masks, 0, with_engine(RSH_ENGINE_BRUTE_FORCE)), "masks"));
}

INSTANTIATE_TEST_SUITE_P(All, Tiles, ::testing::ValuesIn(test::all_cases()), test::case_name);

}  // namespace
