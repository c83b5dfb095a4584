#include "hits/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace bench;

constexpr rsh_hit kHit = {2, 0.25f, 0.25f, 0};
constexpr rsh_hit kNoHit = {INFINITY, 0, 0, RSH_NO_HIT};

// A triangle, and a second one behind it. One ray hits both, one neither.
stability::Scene two_rays() {
    stability::Scene scene;
    scene.mesh.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    scene.mesh.add({0, 0, -1}, {1, 0, -1}, {0, 1, -1});
    scene.rays = {
        {test::make_ray({0.25f, 0.25f, 2}, {0, 0, -1}), test::make_ray({2, 2, 2}, {0, 0, -1})},
        2,
        1};
    return scene;
}

hits::Errors errors_of(const std::vector<rsh_hit>& found, bool is_closed = false,
                       const stability::Scene& scene = two_rays()) {
    const auto kind = is_closed ? stability::Kind::kClosed : stability::Kind::kAimed;
    return hits::count_errors(scene, stability::expected_answers(scene, kind, 100), is_closed,
                              found);
}

// The only count that is not 0 is `key`.
void expect_error(const std::vector<rsh_hit>& found, const char* key) {
    nlohmann::json metrics;
    const hits::Errors errors = errors_of(found);
    errors.put(metrics);
    EXPECT_EQ(errors.all(), 1u) << key;
    EXPECT_NE(metrics["why"], "") << key;
    for (const char* one : {"missed", "spurious", "wrong_triangle", "inexact", "leaks"})
        EXPECT_EQ(metrics[one].get<int>(), std::string(one) == key) << one;
}

TEST(HitErrors, AreNoneWhereAllIsRight) {
    const hits::Errors errors = errors_of({kHit, kNoHit});
    EXPECT_EQ(errors.rays, 2u);
    EXPECT_EQ(errors.judged, 2u);
    EXPECT_EQ(errors.all(), 0u) << errors.first;
}

TEST(HitErrors, AreCountedEachByItsName) {
    expect_error({kNoHit, kNoHit}, "missed");
    expect_error({{3, 0.25f, 0.25f, 1}, kNoHit}, "missed");  // what is behind it is found
    expect_error({kHit, {2, 0, 0, 0}}, "spurious");
    expect_error({kHit, {2, 0, 0, 9}}, "spurious");
    expect_error({{2.001f, 0.25f, 0.25f, 0}, kNoHit}, "inexact");
    expect_error({{2, 0.26f, 0.25f, 0}, kNoHit}, "inexact");
    expect_error({{2, NAN, 0.25f, 0}, kNoHit}, "inexact");
}

// The same triangle twice, one of them nearer by more than rounding.
TEST(HitErrors, CountATriangleThatIsHiddenByALittle) {
    stability::Scene scene = two_rays();
    for (int i = 3; i < 6; ++i) scene.mesh.vertices[size_t(i)].z = 0.01f;
    const rsh_hit nearer = {1.99f, 0.25f, 0.25f, 1};
    EXPECT_EQ(errors_of({nearer, kNoHit}, false, scene).all(), 0u);
    EXPECT_EQ(errors_of({kHit, kNoHit}, false, scene).all(), 1u);
}

TEST(HitErrors, OfAClosedMeshAreLeaks) {
    const hits::Errors errors = errors_of({kHit, kNoHit}, true);
    EXPECT_EQ(errors.leaks, 1u);
    EXPECT_EQ(errors.missed, 1u);
    EXPECT_EQ(errors.first, "ray 1 leaks");
}

TEST(HitErrors, LeaveInactiveRaysOut) {
    stability::Scene scene = two_rays();
    scene.rays.rays[1] = test::inactive_ray();
    const hits::Errors errors = errors_of({kHit, kNoHit}, true, scene);
    EXPECT_EQ(errors.rays, 1u);
    EXPECT_EQ(errors.judged, 1u);
    EXPECT_EQ(errors.all(), 0u);
}

TEST(HitErrors, CountAnswersOfOtherBits) {
    stability::Scene scene = two_rays();
    rsh_hit other = kHit;
    other.u = std::nextafter(other.u, 1.0f);
    EXPECT_EQ(hits::count_differing(scene.rays.rays, {kHit, kNoHit}, {kHit, kNoHit}), 0u);
    EXPECT_EQ(hits::count_differing(scene.rays.rays, {kHit, kNoHit}, {other, kNoHit}), 1u);
    scene.rays.rays[0] = test::inactive_ray();
    EXPECT_EQ(hits::count_differing(scene.rays.rays, {kHit, kNoHit}, {other, kNoHit}), 0u);
}

}  // namespace
