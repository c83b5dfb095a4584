#include "frame/checksum.hpp"

#include <gtest/gtest.h>
#include <rsh/rsh.h>

namespace {

using bench::checksum;

// Published values of FNV-1a.
TEST(Checksum, IsFnv1a) {
    EXPECT_EQ(checksum(std::vector<char>{}), "cbf29ce484222325");
    EXPECT_EQ(checksum(std::vector<char>{'a'}), "af63dc4c8601ec8c");
    EXPECT_EQ(checksum(std::vector<char>{'f', 'o', 'o', 'b', 'a', 'r'}), "85944171f73967e8");
}

TEST(Checksum, DependsOnEveryFieldAndTheOrder) {
    const rsh_hit a = {1.0f, 0.25f, 0.5f, 7}, b = {2.0f, 0.25f, 0.5f, 7};
    const std::string expected = checksum(std::vector<rsh_hit>{a, b});
    EXPECT_EQ(checksum(std::vector<rsh_hit>{a, b}), expected);
    EXPECT_NE(checksum(std::vector<rsh_hit>{b, a}), expected);
    for (rsh_hit changed :
         {rsh_hit{1.0000001f, 0.25f, 0.5f, 7}, rsh_hit{1.0f, -0.25f, 0.5f, 7},
          rsh_hit{1.0f, 0.25f, 0.50000006f, 7}, rsh_hit{1.0f, 0.25f, 0.5f, 6}})
        EXPECT_NE(checksum(std::vector<rsh_hit>{changed, b}), expected);
}

}  // namespace
