// text_test.cpp - texts are put together in the room that is there, and cut off at its end.
#include "device/text.hpp"

#include <gtest/gtest.h>

#include <climits>
#include <cstdint>
#include <string>

#include "device/error.hpp"

namespace {

template <class... Parts>
std::string text_of(const Parts&... parts) {
    char room[256];
    rsh::Text(room, sizeof room).add(parts...);
    return room;
}

TEST(Text, IsMadeOfStringsCharactersAndNumbers) {
    EXPECT_EQ(text_of(), "");
    EXPECT_EQ(text_of("a: is ", 7, ", must be ", std::string("below "), '6'),
              "a: is 7, must be below 6");
    EXPECT_EQ(text_of(INT_MIN, ' ', UINT64_MAX), "-2147483648 18446744073709551615");
    EXPECT_EQ(text_of(-0.25f, ' ', 1e30, ' ', 0), "-0.25 1e+30 0");
}

TEST(Text, IsCutOffAtTheEndOfItsRoom) {
    const std::string whole = "0123456789";
    for (size_t bytes = 1; bytes <= whole.size() + 2; ++bytes) {
        std::string room(whole.size() + 3, '#');
        rsh::Text(&room[0], bytes).add("01234", 567, "89");
        EXPECT_EQ(std::string(room.c_str()), whole.substr(0, bytes - 1));
        EXPECT_EQ(room.substr(bytes), std::string(room.size() - bytes, '#'));
    }
}

TEST(Error, HasATextOfAnyLength) {
    const std::string line(20000, 'x');
    const rsh::Error error(RSH_BUILD_FAILED, "program: ", line);
    const std::string text = error.what();
    EXPECT_EQ(text, ("program: " + line).substr(0, text.size()));
    EXPECT_GT(text.size(), 10000u);
    EXPECT_EQ(rsh::Error(error).status(), RSH_BUILD_FAILED);
}

}  // namespace
