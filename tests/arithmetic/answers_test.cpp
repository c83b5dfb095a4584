// answers_test.cpp - what the probes of arithmetic hold for right: examples worked by hand, and how
// far off a device may be that does not round quotients and roots correctly.
#include "arithmetic/answers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using rsh::Operands;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

float answer(probe_row row, const Operands& operands) {
    for (const rsh::Operation& operation : rsh::operations())
        if (operation.row == row) return static_cast<float>(operation.answer(operands));
    ADD_FAILURE() << "row " << row << " has no operation";
    return kNaN;
}

TEST(Answers, AreRoundedToNearestAndTiesToEven) {
    EXPECT_EQ(answer(RSH_PROBE_SUM, {0x1p24, 1, 0, 0}), 0x1p24f);
    EXPECT_EQ(answer(RSH_PROBE_SUM, {0x1p24 + 2, 1, 0, 0}), 0x1p24f + 4);
    EXPECT_EQ(answer(RSH_PROBE_SUM_REST, {0x1p24, 1, 0, 0}), 1.0f);
    EXPECT_EQ(answer(RSH_PROBE_SUM_REST, {1, 0x1p24 + 2, 0, 0}), -1.0f);
    EXPECT_EQ(answer(RSH_PROBE_PRODUCT, {4097, 4097, 0, 0}), 0x1p24f + 8192);
    EXPECT_EQ(answer(RSH_PROBE_QUOTIENT, {1, 3, 0, 0}), 0x1.555556p-2f);
    EXPECT_EQ(answer(RSH_PROBE_ROOT, {1 + 0x1p-23, 0, 0, 0}), 1.0f);
    EXPECT_EQ(answer(RSH_PROBE_SUM, {0x1.fffffep127, 0x1.fffffep127, 0, 0}), kInfinity);
}

// 4097 * 4097 = 2^24 + 2^13 + 1, halfway between two floats.
TEST(Answers, TellFusedFromRoundedTwice) {
    const double low = 0x1p24 + 8192, high = low + 2;
    EXPECT_EQ(answer(RSH_PROBE_FMA, {4097, 4097, 0x1p-60, 0}), high);
    EXPECT_EQ(answer(RSH_PROBE_FMA, {4097, 4097, -0x1p-60, 0}), low);
    EXPECT_EQ(answer(RSH_PROBE_FMA_NEGATED, {4097, 4097, -0x1p-60, 0}), -high);
    EXPECT_EQ(answer(RSH_PROBE_PRODUCT_REST, {4097, 4097, 0, 0}), 1.0f);
    EXPECT_EQ(answer(RSH_PROBE_PRODUCT_PLUS, {4097, 4097, -low, 0}), 0.0f);
    EXPECT_EQ(answer(RSH_PROBE_MINUS_PRODUCT, {4097, 4097, low, 0}), 0.0f);
    EXPECT_EQ(answer(RSH_PROBE_TWO_PRODUCTS, {4097, 4097, low, 1}), 0.0f);
}

TEST(Answers, AllowSomeUlpsWhereTheyAreNamed) {
    const float third = 1.0f / 3, ulp = 0x1p-25f;
    EXPECT_TRUE(rsh::is_right(third + 2 * ulp, 1.0 / 3, rsh::kQuotientUlps));
    EXPECT_TRUE(rsh::is_right(third - 2 * ulp, 1.0 / 3, rsh::kQuotientUlps));
    EXPECT_FALSE(rsh::is_right(third + 3 * ulp, 1.0 / 3, rsh::kQuotientUlps));
    EXPECT_FALSE(rsh::is_right(third + ulp, 1.0 / 3, 0));
    EXPECT_FALSE(rsh::is_right(kInfinity, 0x1.fffffep127, rsh::kQuotientUlps));
    EXPECT_FALSE(rsh::is_right(0x1.fffffep127f, kInfinity, rsh::kQuotientUlps));
    EXPECT_FALSE(rsh::is_right(kNaN, 1, rsh::kRootUlps));
}

TEST(Answers, AllowZeroBelowTheSmallestNormalOnly) {
    EXPECT_TRUE(rsh::is_right(0, 0x1p-127, 0));
    EXPECT_TRUE(rsh::is_right(-0.0f, 0x1p-127, 0));
    EXPECT_TRUE(rsh::is_right(0x1p-127f, 0x1p-127, 0));
    EXPECT_FALSE(rsh::is_right(0x1p-128f, 0x1p-127, 0));
    EXPECT_FALSE(rsh::is_right(0, 0x1p-126, 0));
    EXPECT_TRUE(rsh::is_right(kNaN, std::sqrt(-1.0), 0));
    EXPECT_FALSE(rsh::is_right(0, std::sqrt(-1.0), 0));
}

}  // namespace
