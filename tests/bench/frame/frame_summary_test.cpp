#include "frame/frame_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bench {
namespace {

struct Row {
    std::string scene, rays, engine;
    int width, triangles;
    double ms, ratio, refit, tests;
};

Case make(const Row& row) {
    return {row.scene + row.rays + row.engine,
            {{"scene", row.scene},
             {"rays", row.rays},
             {"engine", row.engine},
             {"bound", "box"},
             {"width", row.width},
             {"height", row.width},
             {"triangles", row.triangles}},
            {{"ms_total", row.ms},
             {"ratio_embree", row.ratio},
             {"ratio_embree_refit", row.refit},
             {"tests_per_ray", row.tests},
             {"bytes_peak", 64.0 * (row.width * row.width + row.triangles)}}};
}

std::vector<Case> some_cases() {
    return {make({"room-floor-10k", "reflection", "tiles", 512, 10000, 2, 0.1, 0.1, 9}),
            make({"room-floor-80k", "reflection", "tiles", 512, 79900, 4, 2, 0.5, 10}),
            make({"room-floor-80k", "reflection", "tiles", 1024, 79900, 8, 2, 0.5, 10}),
            make({"room-floor-700k", "reflection", "tiles", 512, 699900, 10.2, 4, 0.25, 10}),
            make({"room-floor-700k", "diffuse", "tiles", 512, 699900, 99, 0.5, 0.2, 99}),
            make({"room-floor-700k", "reflection", "paper_faithful", 512, 699900, 204, 0.2, 0.1,
                  80})};
}

nlohmann::json of_engine(const std::vector<Case>& summaries, const std::string& engine) {
    for (const Case& summary : summaries)
        if (summary.params["engine"] == engine) return summary.metrics;
    ADD_FAILURE() << "no summary of " << engine;
    return {};
}

TEST(FrameSummary, AveragesCoherentRaysFromTheWantedSizeUp) {
    const auto tiles = of_engine(summarize(some_cases()), "tiles");
    EXPECT_NEAR(tiles["ratio_embree"], std::cbrt(2.0 * 2.0 * 4.0), 1e-9);
    EXPECT_DOUBLE_EQ(tiles["ratio_embree_300k"], 4.0);
    EXPECT_DOUBLE_EQ(tiles["ratio_embree_least"], 2.0);
    EXPECT_DOUBLE_EQ(tiles["ratio_refit_least"], 0.25);
    EXPECT_DOUBLE_EQ(tiles["ratio_diffuse"], 0.5);
    EXPECT_FALSE(tiles.contains("ratio_second"));
}

// 6.2 ms more for 620,000 triangles; twice the time for four times the pixels.
TEST(FrameSummary, FitsItsSeries) {
    const auto tiles = of_engine(summarize(some_cases()), "tiles");
    EXPECT_NEAR(tiles["ns_per_triangle"], 10.0, 1e-6);
    EXPECT_NEAR(tiles["pixels_exponent"], 0.5, 1e-9);
    EXPECT_NEAR(tiles["bytes_over_bound"], 1.0, 1e-9);
}

TEST(FrameSummary, ComparesWithThePaperOnTheSameRays) {
    const auto tiles = of_engine(summarize(some_cases()), "tiles");
    EXPECT_DOUBLE_EQ(tiles["fewer_tests"], 8.0);
    EXPECT_NEAR(tiles["quicker_700k"], 20.0, 1e-9);
}

TEST(FrameSummary, KeepsOtherSizesOutOfTheMeans) {
    auto cases = some_cases();
    cases.push_back(
        make({"room-floor-80k", "reflection", "tiles", 2048, 79900, 16, 0.9, 0.8, 10}));
    const auto tiles = of_engine(summarize(cases), "tiles");
    EXPECT_NEAR(tiles["ratio_embree"], std::cbrt(2.0 * 2.0 * 4.0), 1e-9);
    EXPECT_DOUBLE_EQ(tiles["ratio_embree_least"], 2.0);
    EXPECT_DOUBLE_EQ(tiles["ratio_series_least"], 0.9);
    EXPECT_NEAR(tiles["pixels_exponent"], 0.5, 1e-9);
}

TEST(FrameSummary, KeepsUpdatedFramesApart) {
    std::vector<Case> cases = some_cases();
    Case refit = cases[3];
    refit.params["refit"] = true;
    refit.metrics["ratio_embree"] = 9.0;
    cases.push_back(refit);
    size_t seen = 0;
    for (const Case& summary : summarize(cases)) {
        if (summary.params["engine"] != "tiles") continue;
        const bool is_refit = summary.params["refit"];
        EXPECT_DOUBLE_EQ(summary.metrics["ratio_embree_300k"], is_refit ? 9.0 : 4.0);
        EXPECT_EQ(summary.name.find("/refit") != std::string::npos, is_refit);
        ++seen;
    }
    EXPECT_EQ(seen, 2u);
}

TEST(FrameSummary, KeepsWidthsOfVectorsApart) {
    std::vector<Case> cases;
    for (const uint32_t width : {8u, 16u})
        for (Case c : some_cases()) {
            c.params["vector_width"] = width;
            c.metrics["ratio_embree"] = c.metrics["ratio_embree"].get<double>() * width;
            cases.push_back(c);
        }
    size_t seen = 0;
    for (const Case& summary : summarize(cases)) {
        if (summary.params["engine"] != "tiles") continue;
        const uint32_t width = summary.params["vector_width"];
        EXPECT_DOUBLE_EQ(summary.metrics["ratio_embree_300k"], 4.0 * width);
        EXPECT_NE(summary.name.find("/vectors:" + std::to_string(width)), std::string::npos)
            << summary.name;
        ++seen;
    }
    EXPECT_EQ(seen, 2u);
}

TEST(FrameSummary, HasNoRatioToAPeerThatIsNotThere) {
    auto cases = some_cases();
    for (Case& c : cases)
        for (const char* metric : {"ratio_embree", "ratio_embree_refit"})
            c.metrics.erase(metric);
    const auto tiles = of_engine(summarize(cases), "tiles");
    EXPECT_FALSE(tiles.contains("ratio_embree"));
    EXPECT_FALSE(tiles.contains("ratio_embree_least"));
    EXPECT_NEAR(tiles["ns_per_triangle"], 10.0, 1e-6);
    EXPECT_NEAR(tiles["quicker_700k"], 20.0, 1e-9);
}

TEST(FrameSummary, LeavesOutWhatWasWrong) {
    auto cases = some_cases();
    cases[3].ok = false;
    const auto tiles = of_engine(summarize(cases), "tiles");
    EXPECT_FALSE(tiles.contains("ratio_embree_300k"));
    EXPECT_FALSE(tiles.contains("ns_per_triangle"));
}

}  // namespace
}  // namespace bench
