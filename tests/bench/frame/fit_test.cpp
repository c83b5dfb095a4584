#include "frame/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bench {
namespace {

TEST(Fit, FindsTheSlopeOfALine) {
    EXPECT_DOUBLE_EQ(slope({{1, 5}, {2, 7}, {5, 13}}), 2.0);
}

// By hand: means 2 and 3; sum of dx*dy = (-1)(-2) + 0 + 1*1 = 3, of dx*dx = 2.
TEST(Fit, FindsTheSlopeOfLeastSquares) {
    EXPECT_DOUBLE_EQ(slope({{1, 1}, {2, 4}, {3, 4}}), 1.5);
}

TEST(Fit, HasNoSlopeWithoutTwoDifferentPlaces) {
    EXPECT_EQ(slope({}), 0.0);
    EXPECT_EQ(slope({{3, 1}}), 0.0);
    EXPECT_EQ(slope({{3, 1}, {3, 2}}), 0.0);
}

TEST(Fit, FindsTheExponentOfAPower) {
    std::vector<Point> points;
    for (const double x : {128.0 * 128, 512.0 * 512, 2048.0 * 2048})
        points.push_back({x, 0.03 * std::pow(x, 0.85)});
    EXPECT_NEAR(exponent(points), 0.85, 1e-12);
}

TEST(Fit, TakesTheGeometricMean) {
    EXPECT_DOUBLE_EQ(geometric_mean({0.5, 2.0, 8.0}), 2.0);
    EXPECT_EQ(geometric_mean({}), 0.0);
}

}  // namespace
}  // namespace bench
