#include "stability/sum.hpp"

#include <gtest/gtest.h>

namespace {

using bench::Case;

Case one(uint64_t missed, double t_error, const char* hash, bool ok) {
    return {"one",
            {},
            {{"rays", 7}, {"missed", missed}, {"t_error_of_budget", t_error}, {"hash", hash}},
            ok};
}

TEST(Sum, AddsFaultsAndTakesTotalsAsTheyAre) {
    const Case sum = bench::stability::sum_of(
        {one(1, 0.25, "a", false), one(2, 0.5, "b", true)}, {100, 2000, 300, 4});
    EXPECT_EQ(sum.metrics["rays"], 100);
    EXPECT_EQ(sum.metrics["pairs"], 2000);
    EXPECT_EQ(sum.metrics["decisions"], 300);
    EXPECT_EQ(sum.metrics["undecided"], 4);
    EXPECT_EQ(sum.metrics["missed"], 3);
    EXPECT_EQ(sum.metrics["t_error_of_budget"], 0.5);
    EXPECT_FALSE(sum.ok);
}

TEST(Sum, HashesAllHashes) {
    const auto hash = [](const char* a, const char* b) {
        return bench::stability::sum_of({one(0, 0, a, true), one(0, 0, b, true)}, {})
            .metrics["hash"];
    };
    EXPECT_EQ(hash("a", "b"), hash("a", "b"));
    EXPECT_NE(hash("a", "b"), hash("b", "a"));
}

// Cases that failed have no metrics but the error.
TEST(Sum, IsWrongWithACaseThatFailed) {
    const Case failed = {"one", {}, {{"error", "none"}}, false};
    EXPECT_FALSE(bench::stability::sum_of({failed}, {}).ok);
    EXPECT_TRUE(bench::stability::sum_of({one(0, 0, "a", true)}, {}).ok);
}

}  // namespace
