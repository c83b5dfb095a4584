#include "mirrors/mirrors_text.hpp"

#include <fmt/format.h>

#include <set>

#include "table/text_table.hpp"

namespace bench::mirrors {
namespace {

using nlohmann::json;

const std::set<size_t> kShown = {1, 2, 4, 8, 12, 16, 24, 32, 48, 64};

std::string number(const json& metrics, const char* key, const char* format = "{:.1e}") {
    const auto found = metrics.find(key);
    if (found == metrics.end()) return "";
    return found->is_null() ? "lost" : fmt::format(fmt::runtime(format), found->get<double>());
}

std::string half_lost(const json& metrics) {
    const json& at = metrics["half_lost_at"];
    return at.is_null() ? "-" : at.dump();
}

TextTable::Row row_of(const Case& c) {
    const json& m = c.metrics;
    return {c.params["line"],
            c.params["bounce"].dump(),
            number(m, "position_error_median"),
            number(m, "position_error_p90"),
            number(m, "direction_error_median"),
            number(m, "direction_error_p90"),
            number(m, "times_the_best", "{:.2f}"),
            fmt::format("{:.1f} %", 100 * m["lost"].get<double>() / m["paths"].get<double>())};
}

}  // namespace

std::string table_of(const std::vector<Case>& cases) {
    TextTable table(
        {"line", "bounce", "position", "90 %", "direction", "90 %", "of best", "lost"}, 1);
    std::string halves;
    for (const Case& c : cases) {
        const json& bounce = c.params["bounce"];
        if (!bounce.is_number())
            halves += fmt::format("  {} {}", c.params["line"].get<std::string>(),
                                  half_lost(c.metrics));
        else if (kShown.count(bounce.get<size_t>()) > 0)
            table.add(row_of(c));
    }
    return fmt::format(
        "\n{} normals, {} paths; medians in radii of the room and radians:\n{}half of the "
        "paths "
        "are lost at bounce:{}\n",
        cases.front().params["normals"].get<std::string>(),
        cases.front().metrics["paths"].get<uint64_t>(), table.text(), halves);
}

}  // namespace bench::mirrors
