#include "paper/bars.hpp"

#include <fmt/format.h>

#include "paper/rows.hpp"

namespace bench::paper {
namespace {

constexpr double kLeastFrameSpeedup = 3;

// museum8 and the 2.3 million triangles are what the paper is slowest at.
double least_speedup(const std::string& row) {
    return row == "museum8" || row == "large" ? 30 : 10;
}

Bar of_paper(const char* what, double ms, double paper_ms, double least) {
    const double most = paper_ms / least;
    return {
        fmt::format("{} is {:.2f}, must be at most {:.4g}: {:g} times below the paper's {:g}",
                    what, ms, most, least, paper_ms),
        ms <= most};
}

}  // namespace

std::vector<Bar> bars(const Case& c) {
    const nlohmann::json& m = c.metrics;
    if (!c.ok || c.params.value("engine", "") != "tiles" || !m.contains("paper_ms")) return {};
    const std::string row = c.params.value("row", "");
    if (row == kBuildRow) {
        const double ratio = m["build_over_copy"];
        return {{fmt::format("build_over_copy is {:.2f}, must be at most {:g}", ratio,
                             kMostBuildOverCopy),
                 ratio <= kMostBuildOverCopy}};
    }
    const double paper_ms = m["paper_ms"];
    return {of_paper("ms", m["ms"], paper_ms, least_speedup(row)),
            of_paper("frame_ms", m["frame_ms"], paper_ms, kLeastFrameSpeedup)};
}

}  // namespace bench::paper
