// replaced_test.cpp - changes of the kernels' text.
#include <gtest/gtest.h>

#include <stdexcept>

#include "budgets/measured_program.hpp"

namespace {

using bench::budgets::replaced;

TEST(Replaced, ChangesEachPlace) {
    EXPECT_EQ(replaced("a / b + a / b", "a / b", "rough(a / b)"),
              "rough(a / b) + rough(a / b)");
}

TEST(Replaced, RefusesATextThatHasNoSuchPlace) {
    EXPECT_THROW(replaced("a / b", "a / c", "d"), std::runtime_error);
}

}  // namespace
