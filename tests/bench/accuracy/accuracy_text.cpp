#include "accuracy/accuracy_text.hpp"

#include <fmt/format.h>

#include "table/members.hpp"

namespace bench::accuracy {

std::string as_text(const Case& c) {
    const nlohmann::json& m = c.metrics;
    std::string text = c.name + ": ";
    if (m.contains("error")) return text + text_of(m, "error") + '\n';
    text +=
        c.ok ? fmt::format("{} ms ({})", cell(m, "ms", 2), cell(m, "ratio", 2)) : "not timed";
    text += fmt::format(", rmse {}, {} % wrong, flip {}", cell(m, "rmse", 4),
                        fmt::format("{:.1f}", 100 * number_of(m, "wrong_pixels")),
                        cell(m, "flip", 4));
    for (const char* key : {"missed", "spurious", "wrong_triangle", "inexact", "differ"})
        if (number_of(m, key) > 0) text += fmt::format(", {} {}", cell(m, key), key);
    return text + '\n';
}

}  // namespace bench::accuracy
