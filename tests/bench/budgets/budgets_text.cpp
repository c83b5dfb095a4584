#include "budgets/budgets_text.hpp"

#include <fmt/format.h>

#include "table/text_table.hpp"

namespace bench::budgets {
namespace {

using nlohmann::json;

std::string figure(const json& metrics, const char* key) {
    return fmt::format("{:.4g}", metrics[key].get<double>());
}

}  // namespace

std::string as_text(const Case& c) {
    const json& m = c.metrics;
    if (m.contains("error"))
        return fmt::format("{}\n    {}\n", c.name, m["error"].get<std::string>());
    return fmt::format("{}: {} of {} {}, {} evaluations\n", c.name, figure(m, "measured_u"),
                       figure(m, "derived_u"), c.params["unit"].get<std::string>(),
                       m["evaluations"].get<uint64_t>()) +
           (c.ok ? "" : fmt::format("    at {}\n", m["worst_input"].dump()));
}

std::string table_of_budgets(const std::vector<Case>& cases) {
    TextTable table({"bound", "division", "unit", "measured", "derived", "granted", "used"}, 3);
    for (const Case& c : cases) {
        const json& m = c.metrics;
        if (m.contains("error")) continue;
        table.add({c.params["bound"], c.params["division"], c.params["unit"],
                   figure(m, "measured_u"), figure(m, "derived_u"), figure(m, "granted_u"),
                   figure(m, "ratio")});
    }
    return table.is_empty() ? "" : '\n' + table.text();
}

}  // namespace bench::budgets
