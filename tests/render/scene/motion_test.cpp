// motion_test.cpp - key frames and placement.
#include "scene/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using render::RigidKey;

glm::vec3 moved(const std::vector<RigidKey>& keys, double time, glm::vec3 p) {
    return render::motion_at(keys, time) * glm::dvec4(p, 1.0f);
}

void expect_near(glm::vec3 a, glm::vec3 b) {
    EXPECT_LT(glm::distance(a, b), 1e-5f)
        << a.x << ' ' << a.y << ' ' << a.z << " instead of " << b.x << ' ' << b.y << ' ' << b.z;
}

// From rest at time 1 to a quarter turn about y, moved by 4 in x and twice as large, at time 3.
std::vector<RigidKey> quarter_turn() {
    const double half = std::sqrt(0.5);
    return {{1.0, glm::vec3(0), render::rotation_of({1, 0, 0, 0}), 1.0f},
            {3.0, glm::vec3(4, 0, 0), render::rotation_of({half, 0, half, 0}), 2.0f}};
}

TEST(Motion, IsTheIdentityWithoutKeys) {
    expect_near(moved({}, 5.0, {1, 2, 3}), {1, 2, 3});
}

TEST(Motion, StandsStillOutsideOfItsKeys) {
    expect_near(moved(quarter_turn(), -9.0, {1, 0, 0}), {1, 0, 0});
    expect_near(moved(quarter_turn(), 99.0, {1, 0, 0}), {4, 0, -2});
}

TEST(Motion, TurnsAtConstantSpeedBetweenKeys) {
    // A third of the way: 30 degrees, a third of the shift, scale 4 / 3.
    const double time = 1.0 + 2.0 / 3.0;
    const float scale = 4.0f / 3.0f;
    expect_near(moved(quarter_turn(), time, {1, 0, 0}),
                {scale * std::cos(0.5235988f) + scale, 0, -scale * 0.5f});
}

TEST(Motion, TurnsAndScalesAboutItsPivot) {
    const auto moved_about = [](double time, glm::vec3 p) {
        return glm::vec3(render::motion_at(quarter_turn(), time, {10, 1, 5}) *
                         glm::dvec4(p, 1.0f));
    };
    expect_near(moved_about(1.0, {11, 1, 5}), {11, 1, 5});
    expect_near(moved_about(3.0, {10, 1, 5}), {14, 1, 5});  // the pivot only moves
    expect_near(moved_about(3.0, {11, 1, 5}), {14, 1, 3});
}

TEST(Motion, StandsABoxOnItsPlace) {
    const glm::mat4 m = render::standing_at({-1, 5, 0}, {3, 7, 8}, {10, 1, 20}, 6.0f);
    expect_near(m * glm::dvec4(1, 5, 4, 1), {10, 1, 20});
    expect_near(m * glm::dvec4(1, 7, 4, 1), {10, 7, 20});
}

TEST(Motion, CannotStandAFlatThing) {
    EXPECT_THROW(render::standing_at({0, 1, 0}, {1, 1, 1}, {0, 0, 0}, 1.0f),
                 std::runtime_error);
}

}  // namespace
