#include <fmt/format.h>

#include "table/members.hpp"
#include "table/sections.hpp"
#include "table/text_table.hpp"

namespace bench {
namespace {

using nlohmann::json;

std::string scene_text(const json& c) {
    const json &params = c["params"], &metrics = c["metrics"];
    return fmt::format("{} ({}): {} triangles, {} rays, {} judged", text_of(params, "scene"),
                       text_of(params, "group"), cell(params, "triangles"),
                       cell(metrics, "rays"), cell(metrics, "judged"));
}

TextTable::Row contender_row(const json& c) {
    const json &params = c["params"], &m = c["metrics"];
    return {"  " + text_of(params, "contender") + (c["ok"].get<bool>() ? "" : " WRONG"),
            cell(m, "ms_total", 2),
            cell(m, "ratio_embree_default", 2),
            cell(m, "ratio_embree_robust", 2),
            cell(m, "missed"),
            cell(m, "spurious"),
            cell(m, "wrong_triangle"),
            cell(m, "inexact"),
            cell(m, "leaks")};
}

}  // namespace

std::string hits_section(const std::vector<ResultFile>& files) {
    TextTable table({"scene, contenders", "ms", "to default", "to robust", "missed", "spurious",
                     "triangle", "inexact", "leaks"},
                    1);
    std::string last;
    for (const ResultFile& file : files) {
        if (file.suite() != "hits") continue;
        for (const json& c : file.cases()) {
            const std::string scene = scene_text(c);
            if (scene != last) table.add_caption(scene);
            last = scene;
            table.add(contender_row(c));
        }
    }
    if (table.is_empty()) return "";
    return "HITS: milliseconds to rebuild and trace, medians; Embree's over it, default and "
           "robust,\nabove 1: quicker than Embree; rays answered wrong, by the oracle\n" +
           table.text();
}

}  // namespace bench
