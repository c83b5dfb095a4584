#include "left_out.hpp"

#include <gtest/gtest.h>

namespace bench {
namespace {

using nlohmann::json;

TEST(LeftOut, NamesContendersOfARowInOneLineAsLongAsTheReasonIsTheSame) {
    const json left_out = {{{"name", "reduce/strategy:auto/n:4"}, {"why", "no time"}},
                           {{"name", "reduce/strategy:peer:cub/n:4"}, {"why", "no time"}},
                           {{"name", "reduce/strategy:horn/n:4"}, {"why", "no room"}},
                           {{"name", "reduce/strategy:auto/n:8"}, {"why", "no time"}},
                           {{"name", "frame/size:4x4/engine:tiles/bound:box"}, {"why", "late"}},
                           {{"name", "tests/rest/2_of_9"}, {"why", "late"}},
                           {{"name", "tests/rest/3_of_9"}, {"why", "late"}},
                           {{"name", "programs/shade"}, {"why", "late"}}};
    EXPECT_EQ(left_out_text(left_out),
              "reduce/n:4: auto, peer:cub: no time\n"
              "reduce/n:4: horn: no room\n"
              "reduce/n:8: auto: no time\n"
              "frame/size:4x4/bound:box: tiles: late\n"
              "tests/rest: 2_of_9, 3_of_9: late\n"
              "programs/shade: late\n");
}

TEST(LeftOut, IsEmptyWhereNothingWas) {
    EXPECT_EQ(left_out_text(json::array()), "");
}

}  // namespace
}  // namespace bench
