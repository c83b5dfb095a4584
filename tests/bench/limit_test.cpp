// limit_test.cpp - what is left out, and what it says.
#include "limit.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "memory.hpp"

namespace bench {
namespace {

TEST(Limit, PassesAndSaysWhichItWas) {
    const Limit none(0), long_one(1000), short_one(1e-9);
    EXPECT_FALSE(none.has_passed());
    EXPECT_EQ(none.left(), std::numeric_limits<double>::infinity());
    EXPECT_FALSE(long_one.has_passed());
    EXPECT_TRUE(short_one.has_passed());
    EXPECT_EQ(Limit(60).when_passed(), "the limit of 60 s has passed");
}

TEST(Estimate, RefusesWhatWouldPassTheLimitByTheLastOfTheSameContender) {
    const Limit limit(100);
    Estimate estimate;
    EXPECT_EQ(estimate.refusal(limit, "horn", 1 << 28), "");
    estimate.add("horn", 1 << 20, 1.0);
    EXPECT_EQ(estimate.refusal(limit, "horn", 1 << 24), "");
    EXPECT_EQ(estimate.refusal(limit, "scan", 1 << 28), "");
    EXPECT_EQ(estimate.refusal(limit, "horn", 1 << 28),
              "would not end within the limit of 100 s");
    EXPECT_EQ(estimate.refusal(Limit(0), "horn", 1 << 28), "");
}

TEST(Estimate, TakesNoLessThanTheLastCaseForLess) {
    Estimate estimate;
    estimate.add("horn", 1 << 20, 101.0);
    EXPECT_NE(estimate.refusal(Limit(100), "horn", 1 << 10), "");
}

TEST(Estimate, RefusesAllOnceTheLimitHasPassed) {
    EXPECT_EQ(Estimate().refusal(Limit(1e-9), "scan", 1), Limit(1e-9).when_passed());
}

MemoryLimits small() {
    return {1000, 600, 2000, false};
}

TEST(Memory, TakesWhatFits) {
    EXPECT_EQ(memory_refusal(small(), {{"input", 600}, {"output", 400}}, 2000), "");
}

TEST(Memory, NamesTheBufferThatIsTooLarge) {
    EXPECT_EQ(memory_refusal(small(), {{"input", 10}, {"output", 601}}, 0),
              "output needs 601 bytes in one buffer, the device allows 600");
}

TEST(Memory, AddsUpAllBuffers) {
    EXPECT_EQ(memory_refusal(small(), {{"input", 600}, {"output", 401}}, 0),
              "needs 1001 bytes of device memory, the device has 1000");
}

TEST(Memory, CountsTheDevicesBuffersToTheHostWhereTheyAreTheSame) {
    MemoryLimits limits = small();
    EXPECT_EQ(memory_refusal(limits, {{"input", 600}}, 1500), "");
    EXPECT_EQ(memory_refusal(limits, {{"input", 600}}, 2001),
              "needs 2001 bytes of host memory, the machine has 2000");
    limits.is_shared = true;
    EXPECT_EQ(memory_refusal(limits, {{"input", 600}}, 1500),
              "needs 2100 bytes of host memory, the machine has 2000");
}

}  // namespace
}  // namespace bench
