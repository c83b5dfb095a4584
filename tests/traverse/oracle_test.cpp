// oracle_test.cpp - what rsh finds against brute force in double precision: only rays
// that pass within rounding of an edge, of another hit or of their own ends may differ, and
// those only among the answers that rounding allows. Closed meshes leak nowhere.
#include <gtest/gtest.h>

#include "oracle/accepts.hpp"
#include "support/cases.hpp"
#include "support/compare.hpp"
#include "support/ways.hpp"

namespace {

using test::Case;
using test::DeviceMesh;

class OracleTraverse : public ::testing::TestWithParam<test::NamedCase> {
protected:
    Case make_case() const {
        test::Random random(12);
        return GetParam().make(random);
    }
};

TEST_P(OracleTraverse, AcceptsEveryHit) {
    const Case c = make_case();
    const auto answers = oracle::closest(c.mesh, c.rays.rays, c.rays.skip);
    const auto hits = closest_hits(DeviceMesh(c.mesh), c.rays);
    EXPECT_TRUE(oracle::hits_are_correct(answers, c.mesh, c.rays.rays, hits));
    RecordProperty("ambiguous_permille", int(1000 * oracle::ambiguous_share(answers)));
    if (GetParam().ordinary && !test::small()) {
        EXPECT_LT(oracle::ambiguous_share(answers), 0.02)
            << "the oracle is hardly sure of anything";
    }
}

TEST_P(OracleTraverse, AcceptsTheOcclusion) {
    const Case c = make_case();
    const auto answers = oracle::closest(c.mesh, c.rays.rays, c.rays.skip);
    const std::vector<uint32_t> clear(c.rays.rays.size(), 0);
    const auto masks = occlusion(DeviceMesh(c.mesh), c.rays, clear, 31);
    EXPECT_TRUE(oracle::occlusion_is_correct(answers, c.rays.rays, masks, 31));
}

INSTANTIATE_TEST_SUITE_P(All, OracleTraverse, ::testing::ValuesIn(test::all_cases()),
                         test::case_name);

// Rays from inside of a closed mesh at its vertices and edges: a miss is a crack.
void expect_no_leak(const test::Mesh& mesh, test::Float3 eye, uint64_t salt) {
    test::Random random(salt);
    const uint32_t side = test::small() ? 16 : 128;
    test::Rays rays = {{}, side, side};
    for (uint32_t i = 0; i < side * side; ++i)
        rays.rays.push_back(test::make_ray(eye, test::point_on_edge(random, mesh) - eye));
    for (const test::TraceOptions& options : test::brute_force_and_all_ways()) {
        const auto hits = closest_hits(DeviceMesh(mesh), rays, options);
        for (size_t i = 0; i < hits.size(); ++i)
            ASSERT_NE(hits[i].primitive, RSH_NO_HIT)
                << name_of(options) << ": ray " << i << " " << rays.rays[i] << " leaks";
    }
}

TEST(Watertight, SphereLetsNoRayOut) {
    expect_no_leak(test::sphere(40, 21), {0.125f, 0.25f, -0.0625f}, 13);
    expect_no_leak(test::sphere(40, 21), {0, 0, 0}, 14);
}

TEST(Watertight, SphereFarFromTheOriginLetsNoRayOut) {
    const test::Float3 far(1000, -3000, 500);
    expect_no_leak(test::scaled(test::sphere(40, 21), 1, far), far, 15);
}

TEST(Watertight, TorusLetsNoRayOut) {
    expect_no_leak(test::torus(24, 36), {1.0f, 0.05f, 0.02f}, 16);
}

TEST(Watertight, HugeAndTinySpheresLetNoRayOut) {
    expect_no_leak(test::scaled(test::sphere(24, 13), 1e15f), {}, 17);
    expect_no_leak(test::scaled(test::sphere(24, 13), 1e-15f), {}, 18);
}

TEST(Watertight, GridLetsNoRayThroughItsVerticesAndEdges) {
    const test::Mesh mesh = test::grid(16);
    test::Random random(19);
    test::Rays rays;
    rays.width = 4096;
    for (uint32_t i = 0; i < rays.width; ++i) {
        const float x = float(random.below(31)) / 16 - 0.9375f;
        const float y = random.chance(0.5f) ? float(random.below(31)) / 16 - 0.9375f
                                            : random.between(-0.9f, 0.9f);
        const test::Float3 eye = test::Float3(0, 0, 2) + random.in_cube();
        rays.rays.push_back(random.chance(0.3f)
                                ? test::make_ray({x, y, 2}, {0.0f, -0.0f, -1})
                                : test::make_ray(eye, test::Float3(x, y, 0) - eye));
    }
    for (const rsh_hit& hit : closest_hits(DeviceMesh(mesh), rays))
        ASSERT_NE(hit.primitive, RSH_NO_HIT);
}

}  // namespace
