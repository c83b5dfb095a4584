#include <fmt/format.h>

#include <map>

#include "table/members.hpp"
#include "table/sections.hpp"
#include "table/text_table.hpp"

namespace bench {
namespace {

using nlohmann::json;

bool is_frame(const json& c) {
    const auto name = c["name"].get<std::string>();
    return name.rfind("frame/build/", 0) != 0 && name.rfind("frame/summary/", 0) != 0;
}

std::string row_text(const json& params) {
    return fmt::format("{} {}x{} {}: {} triangles, {} rays", text_of(params, "scene"),
                       cell(params, "width"), cell(params, "height"), text_of(params, "rays"),
                       cell(params, "triangles"), cell(params, "active_rays"));
}

std::string engine_text(const json& params) {
    return text_of(params, "engine") + '/' + text_of(params, "bound") +
           (is_true(params, "refit") ? "/refit" : "") +
           (number_of(params, "vector_width") > 0 ? "/vectors:" + cell(params, "vector_width")
                                                  : "");
}

std::string rays_per_second(const json& params, const json& metrics) {
    const double rays = number_of(params, "active_rays"), ms = number_of(metrics, "ms_total");
    return rays > 0 && ms > 0 ? fmt::format("{:.1f}", rays / ms * 1e-3) : "-";
}

TextTable::Row frame_row(const json& c) {
    const json &params = c["params"], &metrics = c["metrics"];
    return {"  " + engine_text(params),
            cell(metrics, "ms_bound", 2),
            cell(metrics, "ms_build", 2),
            cell(metrics, "ms_traverse", 2),
            cell(metrics, "ms_total", 2),
            rays_per_second(params, metrics),
            cell(metrics, "tests_per_ray", 1),
            cell(metrics, "mismatches") + (c["ok"].get<bool>() ? "" : " WRONG")};
}

}  // namespace

std::string frame_section(const std::vector<ResultFile>& files) {
    TextTable table({"scene, engines", "bound", "build", "traverse", "total ms", "Mrays/s",
                     "tests/ray", "mismatches"},
                    1);
    std::string last;
    size_t others = 0;
    for (const ResultFile& file : files) {
        if (file.suite() != "frame") continue;
        for (const json& c : file.cases()) {
            if (!is_frame(c)) {
                ++others;
                continue;
            }
            const std::string row = row_text(c["params"]);
            if (row != last) table.add_caption(row);
            last = row;
            table.add(frame_row(c));
        }
    }
    std::string text;
    if (!table.is_empty())
        text = "FRAME: milliseconds of each stage, medians; mismatches with brute force\n" +
               table.text();
    if (others > 0)
        text += fmt::format("{} cases of frame/build and frame/summary: in the files alone\n",
                            others);
    return text;
}

}  // namespace bench
