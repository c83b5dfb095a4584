#include "approximate/approximate_text.hpp"

#include <fmt/format.h>

#include "table/members.hpp"

namespace bench::approximate {

std::string as_text(const Case& c) {
    const nlohmann::json& m = c.metrics;
    std::string text = c.name + ": ";
    if (m.contains("error")) return text + text_of(m, "error") + '\n';
    text += c.ok ? fmt::format("{} ms, exact {} ms ({})", cell(m, "ms", 2),
                               cell(m, "exact_ms", 2), cell(m, "ratio", 2))
                 : "not timed";
    text += fmt::format(", flip {}, {:.3f} % above 0.1, {:.0f} % traced", cell(m, "flip", 5),
                        100 * number_of(m, "flip_above"), 100 * number_of(m, "traced"));
    for (const char* key : {"differ", "unsteady"})
        if (number_of(m, key) > 0) text += fmt::format(", {} {}", cell(m, key), key);
    return text + '\n';
}

}  // namespace bench::approximate
