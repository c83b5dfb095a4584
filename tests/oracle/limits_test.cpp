// limits_test.cpp - what the oracle leaves open at the limits that rsh.h states, and where
// denormals may be flushed.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "oracle/hit.hpp"
#include "support/rays.hpp"

namespace {

using oracle::Denormals;
using test::Float3;

enum class Answer { kNever, kOpen, kCertain };

Answer answer(const oracle::Candidate& c) {
    return c.certain ? Answer::kCertain : c.possible ? Answer::kOpen : Answer::kNever;
}

// A ray along -z, 1 away from a triangle around its line, both `size` large.
Answer with_direction(float length, Denormals denormals, float size = 1) {
    const test::Corners c = {size * Float3(-1, -1, 0), size * Float3(1, -1, 0),
                             size * Float3(0, 1, 0)};
    return answer(
        oracle::intersect(test::make_ray({0, 0, size}, {0, 0, -length}), c, denormals));
}

TEST(OracleLimits, OfDirections) {
    const Denormals kept = Denormals::kKept, flushed = Denormals::kMayBeFlushed;
    // t is the largest float at most.
    EXPECT_EQ(with_direction(0x1.8p-129f, kept, 0x1p-8f), Answer::kNever);
    EXPECT_EQ(with_direction(0x1.8p-128f, kept, 0x1p-8f), Answer::kCertain);
    EXPECT_EQ(with_direction(0x1.8p-128f, flushed, 0x1p-8f), Answer::kOpen);
    EXPECT_EQ(with_direction(0x1p-126f, kept, 0x1p-8f), Answer::kCertain);
    EXPECT_EQ(with_direction(0x1.8p-128f, kept, 4), Answer::kNever);
    EXPECT_EQ(with_direction(0x1p125f, flushed, 16), Answer::kCertain);
    EXPECT_EQ(with_direction(0x1p127f, flushed, 16), Answer::kOpen);
    EXPECT_EQ(with_direction(0x1p127f, kept), Answer::kCertain);
}

TEST(OracleLimits, OfScenesOfDenormals) {
    EXPECT_EQ(with_direction(1, Denormals::kKept, 0x1p-130f), Answer::kCertain);
    EXPECT_EQ(with_direction(1, Denormals::kMayBeFlushed, 0x1p-130f), Answer::kOpen);
    EXPECT_EQ(with_direction(1, Denormals::kMayBeFlushed, 0x1p-110f), Answer::kCertain);
}

// One corner far away, the others 1 apart around the ray's line.
Answer with_far_corner(float far) {
    const test::Corners c = {Float3(-1, -1, 0), Float3(-1, 1, 0), Float3(far, 0, 0)};
    return answer(
        oracle::intersect(test::make_ray({0, 0, 1}, {0, 0, -1}), c, Denormals::kKept));
}

TEST(OracleLimits, OfNeedlesAndFarCorners) {
    EXPECT_EQ(with_far_corner(0x1p10f), Answer::kCertain);
    EXPECT_EQ(with_far_corner(0x1p60f), Answer::kCertain);
    EXPECT_EQ(with_far_corner(0x1p64f), Answer::kOpen);
    EXPECT_EQ(with_far_corner(std::numeric_limits<float>::max()), Answer::kOpen);
    EXPECT_EQ(with_direction(1, Denormals::kKept, 0x1p125f), Answer::kCertain);
    EXPECT_EQ(with_direction(1, Denormals::kKept, 0x1.8p126f), Answer::kOpen);
}

}  // namespace
