// budgets_of_test.cpp - budgets begin with the least and end with all that is wanted; refusals are read.
#include <gtest/gtest.h>

#include "frame_memory/budgets_of.hpp"

namespace {

using bench::memory::Budget;
using bench::memory::budgets_from;
using bench::memory::is_refusal_below;
using bench::memory::keeps_to;
using bench::memory::least_named_by;

std::vector<std::string> names(const std::vector<Budget>& budgets) {
    std::vector<std::string> all;
    for (const Budget& budget : budgets) all.push_back(budget.name);
    return all;
}

TEST(Budgets, GrowFromTheLeastToTheWhole) {
    const std::vector<Budget> budgets = budgets_from(1000, 9000, 2);
    EXPECT_EQ(names(budgets), (std::vector<std::string>{"least", "2x", "4x", "8x", "whole"}));
    EXPECT_EQ(budgets.front().bytes, 1000u);
    EXPECT_EQ(budgets[2].bytes, 4000u);
    EXPECT_EQ(budgets.back().bytes, 9000u);
}

TEST(Budgets, HaveNoStepBeyondTheWhole) {
    EXPECT_EQ(names(budgets_from(1000, 8000, 2)),
              (std::vector<std::string>{"least", "2x", "4x", "whole"}));
    EXPECT_EQ(names(budgets_from(1000, 1500, 4)), (std::vector<std::string>{"least", "whole"}));
}

TEST(Budgets, AreOneWhereTheLeastIsEnough) {
    EXPECT_EQ(names(budgets_from(1000, 1000, 2)), std::vector<std::string>{"least"});
    EXPECT_EQ(names(budgets_from(1000, 10, 2)), std::vector<std::string>{"least"});
}

TEST(Refusal, NamesTheLeast) {
    EXPECT_EQ(least_named_by("rsh_frame_query: RSH_INVALID_VALUE: budget: is 1, must be 0 or "
                             "at least 5000000000"),
              5000000000u);
}

TEST(Refusal, BelowTheLeastSaysWhatItWasAndMustBe) {
    EXPECT_TRUE(is_refusal_below("budget: is 99, must be 0 or at least 100", 100));
    EXPECT_FALSE(is_refusal_below("budget: is 99, must be 0 or at least 128", 100));
    EXPECT_FALSE(is_refusal_below("budget: is 1, must be 0 or at least 100", 100));
    EXPECT_FALSE(is_refusal_below("", 100)) << "it was not refused";
}

TEST(Peak, IsWithinWhatIsAllowed) {
    EXPECT_TRUE(keeps_to(100, 100));
    EXPECT_TRUE(keeps_to(100, 1));
    EXPECT_FALSE(keeps_to(100, 101));
    EXPECT_FALSE(keeps_to(100, 0)) << "nothing was counted";
}

TEST(Refusal, OfSomethingElseIsNone) {
    for (const char* refusal :
         {"", "budget: is 1, must be 0", "width: is 0, must be at least 1"})
        EXPECT_THROW(least_named_by(refusal), std::runtime_error) << refusal;
}

}  // namespace
