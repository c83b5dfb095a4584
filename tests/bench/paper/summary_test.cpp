#include "paper/summary.hpp"

#include <gtest/gtest.h>

namespace bench::paper {
namespace {

Case measured(const char* row, const char* engine, nlohmann::json params, double ms) {
    params.update({{"row", row}, {"engine", engine}});
    return {row, params, {{"ms", ms}, {"ms_build", 0.1 * ms}}, true};
}

TEST(PaperSummary, GrowthHasSlopeAndExponent) {
    std::vector<Case> cases;
    for (const int thousands : {50, 100, 200})
        cases.push_back(
            measured("patio", "paper", {{"triangles", 1000 * thousands}}, 2.0 * thousands));
    const std::vector<Case> found = summarize(cases);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].params["row"], "summary");
    EXPECT_NEAR(found[0].metrics["patio_ns_per_triangle"].get<double>(), 2000, 1e-6);
    EXPECT_NEAR(found[0].metrics["patio_exponent"].get<double>(), 1, 1e-9);
    EXPECT_FALSE(found[0].metrics.contains("statue_exponent"));
}

// Twice as wide are four times as many pixels.
TEST(PaperSummary, PixelsAreWidthSquared) {
    const std::vector<Case> found =
        summarize({measured("resolution", "tiles", {{"width", 128}}, 1),
                   measured("resolution", "tiles", {{"width", 256}}, 2)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].metrics["pixels_exponent"].get<double>(), 0.5, 1e-9);
}

TEST(PaperSummary, SheetsAndBatchesAreRatioAndSlope) {
    const std::vector<Case> found =
        summarize({measured("occlusion", "tiles", {{"layers", 16}}, 12),
                   measured("occlusion", "tiles", {{"layers", 1}}, 4),
                   measured("batches", "tiles", {{"batches", 1}}, 5),
                   measured("batches", "tiles", {{"batches", 64}}, 131)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].metrics["occlusion_ratio"].get<double>(), 3, 1e-9);
    EXPECT_NEAR(found[0].metrics["ms_per_batch"].get<double>(), 2, 1e-9);
}

TEST(PaperSummary, LeastSpeedupIsOfRowsWithATimeOfThePaper) {
    Case slow = measured("several", "tiles", {}, 100),
         quick = measured("statue", "tiles", {}, 10),
         build = measured("build", "tiles", {}, 10);
    slow.metrics.update({{"paper_ms", 300}, {"speedup", 3}});
    quick.metrics.update({{"paper_ms", 4000}, {"speedup", 400}});
    build.metrics.update({{"paper_ms", 2}, {"speedup", 0.2}});
    const std::vector<Case> found = summarize({slow, quick, build});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].metrics["least_speedup"].get<double>(), 3);
    EXPECT_NEAR(found[0].metrics["build_share"].get<double>(), 0.1, 1e-9);
}

TEST(PaperSummary, WrongCasesCountForNothing) {
    Case wrong = measured("several", "tiles", {}, 1);
    wrong.ok = false;
    EXPECT_TRUE(summarize({wrong}).empty());
}

}  // namespace
}  // namespace bench::paper
