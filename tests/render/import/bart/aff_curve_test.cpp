// aff_curve_test.cpp - Kochanek-Bartels curves against what their definition implies.
#include "import/bart/aff_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace render {
namespace {

CurveKey key(double time, glm::dvec3 value) {
    CurveKey k;
    k.time = time;
    k.value = value;
    return k;
}

// Four to eight keys with random times, values and parameters; `value` draws a key's value.
template <typename Draw>
std::vector<CurveKey> random_keys(unsigned seed, Draw draw) {
    std::mt19937 rng(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<CurveKey> keys(4 + seed % 5);
    double time = -3.0;
    for (CurveKey& k : keys) {
        k.time = time += 0.1 + unit(rng);
        draw(k, unit(rng));
        k.tension = unit(rng) - 0.5;
        k.continuity = unit(rng) - 0.5;
        k.bias = unit(rng) - 0.5;
    }
    return keys;
}

TEST(Curve, PassesThroughItsInnerKeysAndIsClampedThere) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const auto keys = random_keys(seed, [](CurveKey& k, double x) {
            k.value = {x, -x, 1.0};
        });
        for (size_t i = 1; i + 1 < keys.size(); ++i)
            EXPECT_LT(glm::distance(point_on_curve(keys, keys[i].time), keys[i].value), 1e-12)
                << "seed " << seed << ", key " << i;
        EXPECT_EQ(point_on_curve(keys, -100.0), keys[1].value) << "seed " << seed;
        EXPECT_LT(glm::distance(point_on_curve(keys, 100.0), keys[keys.size() - 2].value),
                  1e-12);
    }
}

TEST(Curve, KeepsAConstantSpeedAtUnevenTimes) {
    const glm::dvec3 speed(1.0, -2.0, 0.5);
    std::vector<CurveKey> keys;
    for (const double time : {0.0, 1.0, 1.25, 4.0, 4.5, 9.0})
        keys.push_back(key(time, time * speed));
    for (double time = 1.0; time <= 4.5; time += 0.1)
        EXPECT_LT(glm::distance(point_on_curve(keys, time), time * speed), 1e-12) << time;
}

TEST(Curve, FullTensionStopsAtTheKeys) {
    std::vector<CurveKey> keys;
    for (int i = 0; i < 4; ++i)
        keys.push_back(key(i, {i * i, 0.0, 0.0})), keys[i].tension = 1.0;
    // Between x = 1 and x = 4 with no speed at either end: 1 + 3 (3 u^2 - 2 u^3).
    EXPECT_NEAR(point_on_curve(keys, 1.25).x, 1.0 + 3.0 * (3.0 / 16.0 - 2.0 / 64.0), 1e-12);
}

TEST(Curve, BiasAndContinuityWeighTheNeighbours) {
    std::vector<CurveKey> keys;
    for (const double x : {0.0, 1.0, 3.0, 3.0}) keys.push_back(key(keys.size(), {x, 0.0, 0.0}));
    // The middle of a Hermite segment: (p1 + p2) / 2 + (leaving - arriving) / 8. Neutral:
    // leaving = (2 + 1) / 2, arriving = (0 + 2) / 2.
    EXPECT_NEAR(point_on_curve(keys, 1.5).x, 2.0 + (1.5 - 1.0) / 8.0, 1e-12);
    keys[1].bias = 1.0;  // leaving = 2 * 1 / 2: only what came before
    EXPECT_NEAR(point_on_curve(keys, 1.5).x, 2.0 + (1.0 - 1.0) / 8.0, 1e-12);
    keys[1].bias = 0.0;
    keys[2].continuity = -1.0;  // arriving = 2 * 2 / 2: only this segment
    EXPECT_NEAR(point_on_curve(keys, 1.5).x, 2.0 + (1.5 - 2.0) / 8.0, 1e-12);
}

TEST(Curve, JumpsBetweenKeysOfEqualTime) {
    std::vector<CurveKey> keys;
    for (const double time : {0.0, 1.0, 2.0, 2.0, 3.0, 4.0})
        keys.push_back(key(time, glm::dvec3(keys.size())));
    EXPECT_EQ(point_on_curve(keys, 2.0).x, 3.0);
    EXPECT_TRUE(std::isfinite(point_on_curve(keys, 1.999).x));
    const std::vector<CurveKey> all_equal(4, key(1.0, glm::dvec3(5.0)));
    EXPECT_EQ(point_on_curve(all_equal, 1.0).x, 5.0);
}

// About one axis, squad with these inner points is the cubic Hermite of the angle: both are
// (1 - u) a + u b + u (1 - u) [(1 - u) (leaving - l) + u (l - arriving)].
TEST(Curve, RotationAboutOneAxisIsTheCurveOfItsAngle) {
    const glm::dvec3 axis(0.36, -0.48, 0.8);
    for (unsigned seed = 0; seed < 20; ++seed) {
        const auto rotations = random_keys(seed, [&](CurveKey& k, double x) {
            k.value = 3.0 * axis;  // its length does not matter
            k.degrees = 170.0 * x;
        });
        auto angles = rotations;
        for (CurveKey& k : angles) k.value = glm::dvec3(k.degrees, 0.0, 0.0);
        for (double u = 0.0; u <= 1.0; u += 0.03) {
            const double time = glm::mix(rotations[1].time, rotations[2].time, u);
            const double degrees = point_on_curve(angles, time).x;
            const glm::dquat expected = glm::angleAxis(glm::radians(degrees), axis);
            const glm::dquat actual = rotation_on_curve(rotations, time);
            EXPECT_NEAR(std::abs(glm::dot(expected, actual)), 1.0, 1e-12)
                << "seed " << seed << ", u " << u << ", " << degrees << " degrees";
        }
    }
}

TEST(Curve, RotationsTakeTheShorterWay) {
    std::vector<CurveKey> keys;
    for (const double degrees : {0.0, 0.0, 350.0, 350.0}) {
        keys.push_back(key(static_cast<double>(keys.size()), {0.0, 1.0, 0.0}));
        keys.back().degrees = degrees;
    }
    const glm::dvec3 ahead = rotation_on_curve(keys, 1.5) * glm::dvec3(0.0, 0.0, -1.0);
    EXPECT_NEAR(ahead.x, -std::sin(glm::radians(-5.0)), 1e-9);
    EXPECT_NEAR(ahead.z, -std::cos(glm::radians(5.0)), 1e-9);
}

}  // namespace
}  // namespace render
