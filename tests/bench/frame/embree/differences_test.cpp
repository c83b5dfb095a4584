#include "frame/embree/differences.hpp"

#include <gtest/gtest.h>

namespace bench {
namespace {

constexpr rsh_hit kMiss = {1e30f, 0, 0, RSH_NO_HIT};

// In the middle of triangle `primitive`.
rsh_hit middle(float t, rsh_uint primitive) {
    return {t, 0.3f, 0.3f, primitive};
}

rsh_hit edge(float t, rsh_uint primitive) {
    return {t, 0.4f, 0.5999f, primitive};
}

TEST(Differences, AreNoneForTheSameHitAndForNoHitAtAll) {
    EXPECT_EQ(compare(middle(2, 7), middle(2.00001f, 7), 1), Difference::kNone);
    EXPECT_EQ(compare(kMiss, kMiss, 1), Difference::kNone);
}

TEST(Differences, AreNoneForTheSamePlaceRightAtTheOrigin) {
    EXPECT_EQ(compare(middle(1.53836e-5f, 7), middle(1.53886e-5f, 7), 1), Difference::kNone);
    EXPECT_EQ(compare(middle(1.5e-5f, 7), rsh_hit{1.505e-5f, 0.4f, 0.3f, 7}, 1),
              Difference::kOther);
}

TEST(Differences, KnowAnotherTriangleAtTheSameDistance) {
    EXPECT_EQ(compare(middle(2, 7), middle(2, 8), 1), Difference::kSameDistance);
}

TEST(Differences, KnowARayThatSlipsThroughAnEdge) {
    EXPECT_EQ(compare(edge(2, 7), middle(3, 8), 1), Difference::kEdge);
    EXPECT_EQ(compare(middle(3, 8), edge(2, 7), 1), Difference::kEdge);
    EXPECT_EQ(compare(edge(2, 7), kMiss, 1), Difference::kEdge);
    EXPECT_EQ(compare(kMiss, edge(2, 7), 1), Difference::kEdge);
}

// The farther hit's edge explains nothing: the nearer one was there to be found.
TEST(Differences, DoNotExcuseANearerHitByTheFartherOnesEdge) {
    EXPECT_EQ(compare(middle(2, 7), edge(3, 8), 1), Difference::kOther);
    EXPECT_EQ(compare(edge(3, 8), middle(2, 7), 1), Difference::kOther);
}

TEST(Differences, KnowATriangleSeenAlongItsPlane) {
    EXPECT_EQ(compare(middle(2, 7), kMiss, 0.001f), Difference::kGrazing);
    EXPECT_EQ(compare(middle(2, 7), middle(2.1f, 7), -0.001f), Difference::kGrazing);
}

TEST(Differences, CallAllElseOther) {
    EXPECT_EQ(compare(middle(2, 7), kMiss, 1), Difference::kOther);
    EXPECT_EQ(compare(middle(2, 7), middle(2.1f, 7), 1), Difference::kOther);
}

TEST(Differences, AreCountedByCause) {
    DifferenceCounts counts;
    for (const Difference d : {Difference::kNone, Difference::kSameDistance, Difference::kEdge,
                               Difference::kEdge, Difference::kGrazing, Difference::kOther})
        counts.add(d);
    EXPECT_EQ(counts.same_distance, 1u);
    EXPECT_EQ(counts.edge, 2u);
    EXPECT_EQ(counts.grazing, 1u);
    EXPECT_EQ(counts.other, 1u);
}

}  // namespace
}  // namespace bench
