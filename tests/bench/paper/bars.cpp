#include "paper/bars.hpp"

#include <fmt/format.h>

#include "paper/rows.hpp"

namespace bench::paper {
namespace {

constexpr double kLeastFrameSpeedup = 3;
constexpr double kMostOutOfCoreMs = 10000;
constexpr double kMostProcessBytes = 1024.0 * 1024 * 1024;

// museum8 and the 2.3 million triangles are what the paper is slowest at.
double least_speedup(const std::string& row) {
    return row == "museum8" || row == "large" || row == "large_batches" ? 30 : 10;
}

Bar of_paper(const char* what, double ms, double paper_ms, double least) {
    const double most = paper_ms / least;
    return {
        fmt::format("{} is {:.2f}, must be at most {:.4g}: {:g} times below the paper's {:g}",
                    what, ms, most, least, paper_ms),
        ms <= most};
}

// Of the scene that no memory holds.
std::vector<Bar> of_little_memory(const Case& c) {
    const double frame_ms = c.metrics["frame_ms"], process = c.metrics["process_bytes"],
                 bytes = c.metrics["bytes_peak"], budget = c.params["budget"];
    return {
        {fmt::format("frame_ms is {:.0f}, must be at most {:g}", frame_ms, kMostOutOfCoreMs),
         frame_ms <= kMostOutOfCoreMs},
        {fmt::format("process_bytes is {:.0f}, must be below {:.0f}", process,
                     kMostProcessBytes),
         process < kMostProcessBytes},
        {fmt::format("bytes_peak is {:.0f}, must be at most {:.0f}", bytes, budget),
         bytes <= budget}};
}

}  // namespace

std::vector<Bar> bars(const Case& c) {
    const nlohmann::json& m = c.metrics;
    const std::string row = c.params.value("row", "");
    if (c.ok && row == "out_of_core") return of_little_memory(c);
    if (!c.ok || c.params.value("engine", "") != "tiles" || !m.contains("paper_ms")) return {};
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
