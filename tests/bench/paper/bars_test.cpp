#include "paper/bars.hpp"

#include <gtest/gtest.h>

namespace bench::paper {
namespace {

Case of_row(const char* row, double ms, double frame_ms, double paper_ms) {
    return {row,
            {{"row", row}, {"engine", "tiles"}},
            {{"ms", ms}, {"frame_ms", frame_ms}, {"paper_ms", paper_ms}},
            true};
}

TEST(PaperBars, ATenthOfThePapersTimeAndAThirdOfTheFrame) {
    const std::vector<Bar> good = bars(of_row("several", 30.2, 100, 302));
    ASSERT_EQ(good.size(), 2u);
    EXPECT_TRUE(good[0].holds);
    EXPECT_TRUE(good[1].holds);
    const std::vector<Bar> poor = bars(of_row("several", 30.3, 101, 302));
    EXPECT_FALSE(poor[0].holds);
    EXPECT_FALSE(poor[1].holds);
}

TEST(PaperBars, LittleMemoryForTheSceneThatNoneHolds) {
    const auto made = [](double frame_ms, double process_bytes, double bytes) {
        return Case{"out_of_core",
                    {{"row", "out_of_core"}, {"engine", "tiles"}, {"budget", 1000}},
                    {{"ms", 1},
                     {"frame_ms", frame_ms},
                     {"process_bytes", process_bytes},
                     {"bytes_peak", bytes}},
                    true};
    };
    for (const Bar& bar : bars(made(10000, 1e9, 1000))) EXPECT_TRUE(bar.holds) << bar.what;
    EXPECT_FALSE(bars(made(10001, 1e9, 1000))[0].holds);
    EXPECT_FALSE(bars(made(10000, 1.1e9, 1000))[1].holds);
    EXPECT_FALSE(bars(made(10000, 1e9, 1001))[2].holds);
}

TEST(PaperBars, AThirtiethWhereThePaperIsSlowest) {
    EXPECT_TRUE(bars(of_row("museum8", 111, 1, 3330))[0].holds);
    EXPECT_FALSE(bars(of_row("museum8", 112, 1, 3330))[0].holds);
    EXPECT_TRUE(bars(of_row("large", 616, 1, 18500))[0].holds);
    EXPECT_FALSE(bars(of_row("large", 617, 1, 18500))[0].holds);
}

TEST(PaperBars, TheBuildIsComparedWithACopy) {
    Case build = of_row("build", 4, 4, 2);
    build.metrics["build_over_copy"] = 1.2;
    ASSERT_EQ(bars(build).size(), 1u);
    EXPECT_TRUE(bars(build)[0].holds);
    build.metrics["build_over_copy"] = 1.21;
    EXPECT_FALSE(bars(build)[0].holds);
}

TEST(PaperBars, NoneOfOtherEnginesAndOtherRows) {
    Case c = of_row("several", 1, 1, 302);
    c.params["engine"] = "paper";
    EXPECT_TRUE(bars(c).empty());
    c = of_row("several", 1, 1, 302);
    c.metrics.erase("paper_ms");
    EXPECT_TRUE(bars(c).empty());
    c = of_row("several", 1, 1, 302);
    c.ok = false;
    EXPECT_TRUE(bars(c).empty());
}

}  // namespace
}  // namespace bench::paper
