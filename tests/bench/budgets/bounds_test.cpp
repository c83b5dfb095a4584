// bounds_test.cpp - the list of bounds.
#include "budgets/bound.hpp"

#include <gtest/gtest.h>

#include <set>

namespace {

using bench::budgets::all_bounds;
using bench::budgets::Bound;

TEST(Bounds, HaveNamesOfTheirOwn) {
    std::set<std::string> names;
    for (const Bound& bound : all_bounds())
        EXPECT_TRUE(names.insert(bound.name).second) << bound.name << " is there twice";
    EXPECT_FALSE(names.empty());
}

TEST(Bounds, AreNotAboveWhatTheCodeHasRoomFor) {
    for (const Bound& bound : all_bounds()) {
        EXPECT_GT(bound.derived, 0) << bound.name;
        EXPECT_LE(bound.derived, bound.granted) << bound.name;
        EXPECT_LE(bound.rough, bound.granted) << bound.name;
        if (bound.rough > 0) {
            EXPECT_GE(bound.rough, bound.derived) << bound.name;
        }
    }
}

}  // namespace
