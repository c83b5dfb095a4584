// oracle_test.cpp - the judges judged: exact signs, verdicts at edges, and that a wrong answer
// is refused. Needs no device.
#include <gtest/gtest.h>

#include "oracle/accepts.hpp"
#include "oracle/containment.hpp"
#include "oracle/exact.hpp"
#include "oracle/judge.hpp"

namespace {

using test::Float3;

test::Mesh one_triangle() {
    test::Mesh mesh;
    mesh.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    return mesh;
}

std::vector<rsh_hit> hit_of(float t, float u, float v, uint32_t primitive) {
    rsh_hit hit;
    hit.t = t, hit.u = u, hit.v = v, hit.primitive = primitive;
    return {hit};
}

TEST(ExactSide, IsZeroOnlyOnTheLine) {
    const Float3 o(0.1f, 0.2f, 3.0f), p(-0.7f, 0.3f, 0.9f);
    const Float3 d = p - o;  // rounded: p is on the line of the ray only if it was exact
    EXPECT_EQ(oracle::side_of_edge({0, 0, 1}, {0, 0, -1}, {-1, 0, 0}, {1, 0, 0}), 0);
    EXPECT_EQ(oracle::side_of_edge(o, {1, 1, 1}, p, p), 0);
    const int side = oracle::side_of_edge(o, d, p, {1, 0, 0});
    EXPECT_EQ(oracle::side_of_edge(o, d, {1, 0, 0}, p), -side);
}

TEST(ExactSide, SeesTheLastBitAcrossTheWholeRangeOfFloats) {
    const float tiny = 0x1p-149f, huge = 0x1p100f;
    EXPECT_EQ(oracle::side_of_edge({0, 0, huge}, {0, 0, -1}, {-1, tiny, 0}, {1, tiny, 0}), 1);
    EXPECT_EQ(oracle::side_of_edge({0, 0, huge}, {0, 0, -1}, {-1, -tiny, 0}, {1, -tiny, 0}),
              -1);
}

TEST(OracleIntersect, SaysCertainInsideAndImpossibleOutside) {
    test::Corners corners;
    one_triangle().corners(0, &corners);
    const auto inside =
        oracle::intersect(test::make_ray({0.25f, 0.25f, 2}, {0, 0, -1}), corners);
    EXPECT_TRUE(inside.certain && inside.exact && inside.possible);
    EXPECT_DOUBLE_EQ(inside.t, 2);
    EXPECT_DOUBLE_EQ(inside.u, 0.25);
    const auto outside =
        oracle::intersect(test::make_ray({0.75f, 0.75f, 2}, {0, 0, -1}), corners);
    EXPECT_FALSE(outside.certain || outside.exact || outside.possible);
}

// Along x all corners are at the depth 0, along z they are not.
TEST(OracleIntersect, LeavesOpenAlongWhichOfEqualAxesTIsMeasured) {
    const test::Corners wall = {Float3(0, 0, 0), Float3(0, 4, 0), Float3(0, 0, 4)};
    const auto hit = oracle::intersect(test::make_ray({0, 1, 1}, {1, 0.5f, 1}), wall);
    EXPECT_TRUE(hit.possible && hit.exact);
    EXPECT_EQ(hit.t, 0);
    EXPECT_GT(hit.t_high, 0x1p-24);
    EXPECT_LT(hit.t_low, -0x1p-24);
    const auto deeper = oracle::intersect(test::make_ray({0, 1, 1}, {1, 0.5f, 0.9f}), wall);
    EXPECT_LT(deeper.t_high, 0x1p-100);
}

TEST(OracleIntersect, LeavesBothAnswersOpenOnAnEdge) {
    test::Corners corners;
    one_triangle().corners(0, &corners);
    const auto edge = oracle::intersect(test::make_ray({0.5f, 0, 2}, {0, 0, -1}), corners);
    EXPECT_TRUE(edge.exact && edge.possible);
    EXPECT_FALSE(edge.certain);
}

TEST(OracleIntersect, KnowsTheEndsOfTheRay) {
    test::Corners corners;
    one_triangle().corners(0, &corners);
    const Float3 o(0.25f, 0.25f, 2), d(0, 0, -1);
    EXPECT_FALSE(oracle::intersect(test::make_ray(o, d, 0, 1.99f), corners).possible);
    EXPECT_FALSE(oracle::intersect(test::make_ray(o, d, 2.01f), corners).possible);
    EXPECT_TRUE(oracle::intersect(test::make_ray(o, d, 0, 2), corners).exact);
    EXPECT_FALSE(oracle::intersect(test::make_ray(o, d, 0, 2), corners).certain);
    EXPECT_FALSE(oracle::intersect(test::make_ray(o, d, 2, 1), corners).possible);
}

TEST(OracleClosest, RefusesEveryWrongAnswer) {
    const test::Mesh mesh = one_triangle();
    const std::vector<rsh_ray> rays = {test::make_ray({0.25f, 0.5f, 2}, {0, 0, -1})};
    const auto answers = oracle::closest(mesh, rays);
    const auto accepts = [&](const std::vector<rsh_hit>& hits) {
        return bool(oracle::hits_are_correct(answers, mesh, rays, hits));
    };
    EXPECT_TRUE(accepts(hit_of(2, 0.25f, 0.5f, 0)));
    EXPECT_FALSE(accepts(hit_of(2.001f, 0.25f, 0.5f, 0)));
    EXPECT_FALSE(accepts(hit_of(2, 0.26f, 0.5f, 0)));
    EXPECT_FALSE(accepts(hit_of(2, 0.25f, 0.5f, 1)));
    EXPECT_FALSE(accepts(hit_of(INFINITY, 0, 0, RSH_NO_HIT)));
    EXPECT_FALSE(oracle::occlusion_is_correct(answers, rays, {0}, 0));
    EXPECT_TRUE(oracle::occlusion_is_correct(answers, rays, {4}, 2));
}

TEST(OracleJudge, NamesTheFault) {
    using oracle::Fault;
    test::Mesh mesh = one_triangle();
    mesh.add({0, 0, -1}, {1, 0, -1}, {0, 1, -1});
    const rsh_ray ray = test::make_ray({0.25f, 0.5f, 2}, {0, 0, -1});
    const oracle::Answer answer = oracle::closest(mesh, {ray})[0];
    const auto fault = [&](const rsh_hit& hit) {
        return oracle::judge_hit(answer, mesh, ray, hit).fault;
    };
    EXPECT_EQ(fault({2, 0.25f, 0.5f, 0}), Fault::kNone);
    EXPECT_EQ(fault({INFINITY, 0, 0, RSH_NO_HIT}), Fault::kMissed);
    EXPECT_EQ(fault({3, 0.25f, 0.5f, 1}), Fault::kMissed);
    EXPECT_EQ(fault({2.001f, 0.25f, 0.5f, 0}), Fault::kSpurious);
    EXPECT_EQ(fault({NAN, 0.25f, 0.5f, 0}), Fault::kSpurious);
    EXPECT_EQ(fault({2, 0.25f, 0.5f, 2}), Fault::kSpurious);
    EXPECT_EQ(oracle::judge_occlusion(answer, true).fault, Fault::kNone);
    EXPECT_EQ(oracle::judge_occlusion(answer, false).fault, Fault::kMissed);
    EXPECT_EQ(oracle::judge_occlusion({}, true).fault, Fault::kSpurious);
}

TEST(OracleJudge, MeasuresTheErrorAgainstTheBudget) {
    const test::Mesh mesh = one_triangle();
    const rsh_ray ray = test::make_ray({0.25f, 0.5f, 2}, {0, 0, -1});
    const oracle::Answer answer = oracle::closest(mesh, {ray})[0];
    const auto share = [&](float t) {
        return oracle::judge_hit(answer, mesh, ray, {t, 0.25f, 0.5f, 0}).t_error_of_budget;
    };
    EXPECT_EQ(share(2), 0);
    EXPECT_GT(share(2 + 0x1p-20f), 0);
    EXPECT_DOUBLE_EQ(share(2 + 0x1p-19f), 2 * share(2 + 0x1p-20f));
    EXPECT_LE(share(2 + 0x1p-19f), 1);
}

TEST(OracleClosest, CountsWhatItCannotDecide) {
    const test::Mesh mesh = one_triangle();
    const auto undecided = [&](test::Float3 from) {
        return oracle::closest(mesh, {test::make_ray(from, {0, 0, -1})})[0].undecided;
    };
    EXPECT_EQ(undecided({0.25f, 0.5f, 2}), 0u);
    EXPECT_EQ(undecided({0.25f, 0, 2}), 1u);
    EXPECT_EQ(undecided({2, 2, 2}), 0u);
}

TEST(OracleClosest, FindsWhatTheScalarLoopFinds) {
    test::Random random(1);
    const test::Mesh mesh = test::random_soup(random, 1500);
    const test::Rays rays = test::random_rays(random, 200, 1);
    const auto answers = oracle::closest(mesh, rays.rays);
    for (size_t i = 0; i < rays.rays.size(); ++i) {
        double t = INFINITY;
        uint32_t primitive = RSH_NO_HIT;
        for (uint32_t k = 0; k < mesh.triangle_count(); ++k) {
            test::Corners corners;
            mesh.corners(k, &corners);
            const auto candidate = oracle::intersect(rays.rays[i], corners);
            if (candidate.exact && candidate.t < t) t = candidate.t, primitive = k;
        }
        ASSERT_EQ(answers[i].primitive, primitive) << "ray " << i;
    }
}

TEST(OracleContainment, HasNoTolerance) {
    const oracle::Node node = {{0, 0, 0}, 1, {0, 0, 1}, 0.5f};
    const float above = std::nextafter(1.0f, 2.0f);
    EXPECT_TRUE(oracle::starts_inside(node, test::make_ray({1, 0, 0}, {0, 0, 1})));
    EXPECT_FALSE(oracle::starts_inside(node, test::make_ray({above, 0, 0}, {0, 0, 1})));
    const float x = 0.5f, z = std::sqrt(0.75f);
    EXPECT_TRUE(oracle::points_inside(node, test::make_ray({}, {x - 1e-7f, 0, z})));
    EXPECT_FALSE(oracle::points_inside(node, test::make_ray({}, {x + 1e-7f, 0, z})));
    EXPECT_FALSE(oracle::points_inside(node, test::make_ray({}, {0, 0, -1})));
}

}  // namespace
