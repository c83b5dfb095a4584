#include "paper/paper_text.hpp"

#include <fmt/format.h>

#include "paper/bars.hpp"
#include "table/members.hpp"

namespace bench::paper {
namespace {

using nlohmann::json;

std::string times_text(const json& m) {
    std::string text = fmt::format("{} ms", cell(m, "ms", 2));
    if (m.contains("frame_ms"))
        text += fmt::format(", the frame {} ms", cell(m, "frame_ms", 2));
    if (m.contains("paper_ms"))
        text += fmt::format("; the paper {} ms, {} times as long", cell(m, "paper_ms"),
                            cell(m, "speedup", 1));
    return text;
}

std::string shares_text(const json& m) {
    std::string text;
    for (const char* stage : {"build", "tests", "reduction", "intersect", "shade", "other"})
        text += fmt::format("{}{} {:.0f}", text.empty() ? "" : ", ", stage,
                            100 * number_of(m, ("share_" + std::string(stage)).c_str()));
    return "percent of the frame: " + text;
}

}  // namespace

std::string as_text(const Case& c) {
    const json& m = c.metrics;
    std::string text = c.name + "\n    ";
    if (!c.ok)
        return text + "not timed: " +
               (m.contains("error") ? text_of(m, "error")
                                    : cell(m, "mismatches") + " mismatches") +
               '\n';
    text += times_text(m) + '\n';
    if (m.contains("share_build")) text += "    " + shares_text(m) + '\n';
    if (c.params.contains("spawn_share"))
        text += fmt::format("    {:.1f} % of the pixels spawn rays{}\n",
                            100 * number_of(c.params, "spawn_share"),
                            c.params.contains("reflectors")
                                ? "; reflectors seen: " + cell(c.params, "reflectors")
                                : "");
    for (const Bar& bar : bars(c))
        text += fmt::format("    {}: {}\n", bar.holds ? "holds" : "MISSED", bar.what);
    return text;
}

}  // namespace bench::paper
