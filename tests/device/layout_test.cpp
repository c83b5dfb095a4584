// layout_test.cpp - where the parts of a scratch buffer lie: none over another, unless it says so.
#include <gtest/gtest.h>

#include "device/layout.hpp"

namespace {

using rsh::Layout;

TEST(Layout, PutsPartsOneAfterTheOther) {
    Layout layout(64);
    layout.add("a", 100);
    layout.add_array<float>("b", 3);
    ASSERT_EQ(layout.parts().size(), 2u);
    EXPECT_EQ(layout.parts()[0].offset, 0u);
    EXPECT_EQ(layout.parts()[1].offset, 128u);
    EXPECT_EQ(layout.parts()[1].bytes, 12u);
    EXPECT_EQ(layout.bytes(), 192u);
}

// Whether what comes later is larger or smaller.
TEST(Layout, UsesPartsAgain) {
    for (const size_t later : {64u, 640u}) {
        SCOPED_TRACE(std::to_string(later) + " bytes later");
        Layout layout(64);
        layout.add("kept", 64);
        layout.add("early", 64);
        layout.add("early too", 128);
        layout.reuse_from("early");
        layout.add("late", later);
        EXPECT_EQ(layout.parts().back().offset, 64u);
        EXPECT_EQ(layout.bytes(), 64 + std::max<size_t>(192, later));
    }
}

// A name that was mistyped, or a part that this call does not have.
TEST(Layout, RefusesNamesThatItHasNot) {
    Layout layout(64);
    layout.add("empty", 0);
    layout.add("full", 64);
    EXPECT_TRUE(layout.has("empty"));
    EXPECT_FALSE(layout.has("ful"));
    EXPECT_EQ(layout.number_of("full"), 1u);
    EXPECT_THROW(layout.number_of("ful"), std::logic_error);
    EXPECT_THROW(layout.reuse_from("ful"), std::logic_error);
    EXPECT_EQ(layout.bytes(), 64u);
}

}  // namespace
