// struct_size_test.cpp - a struct of an older header is read and written as far as it goes,
// shown on one that has grown.
#include <gtest/gtest.h>

#include "api/struct_size.hpp"

namespace {

struct Grown {
    size_t struct_size;
    cl_ulong first;
    cl_ulong added;
};

}  // namespace

template <>
struct rsh::FirstVersion<Grown> {
    static constexpr size_t bytes = offsetof(Grown, added);
};

namespace {

constexpr size_t kOld = offsetof(Grown, added);

TEST(StructSize, IsThatOfTheFirstVersionAtLeastAndOfThisOneAtMost) {
    EXPECT_FALSE(rsh::is_known_size<Grown>(0));
    EXPECT_FALSE(rsh::is_known_size<Grown>(kOld - 1));
    EXPECT_TRUE(rsh::is_known_size<Grown>(kOld));
    EXPECT_TRUE(rsh::is_known_size<Grown>(sizeof(Grown)));
    EXPECT_FALSE(rsh::is_known_size<Grown>(sizeof(Grown) + 1));
    EXPECT_FALSE(rsh::is_known_size<Grown>(~size_t{0}));
}

TEST(StructSize, LeavesMembersZeroThatTheCallerDoesNotHave) {
    const Grown callers = {kOld, 3, 99};
    const Grown copy = rsh::widened(&callers);
    EXPECT_EQ(copy.struct_size, sizeof(Grown));
    EXPECT_EQ(copy.first, 3u);
    EXPECT_EQ(copy.added, 0u);
    const Grown full = {sizeof(Grown), 3, 99};
    EXPECT_EQ(rsh::widened(&full).added, 99u);
}

TEST(StructSize, KeepsResultsInsideWhatTheCallerHas) {
    Grown callers = {kOld, 3, 99};
    rsh::hand_back(Grown{sizeof(Grown), 4, 5}, &callers);
    EXPECT_EQ(callers.struct_size, kOld);
    EXPECT_EQ(callers.first, 4u);
    EXPECT_EQ(callers.added, 99u);
}

}  // namespace
