#include "hits/hits_text.hpp"

#include <fmt/format.h>

#include "table/members.hpp"

namespace bench::hits {

std::string as_text(const Case& c) {
    const nlohmann::json& m = c.metrics;
    std::string text = c.name + ": ";
    if (m.contains("error")) return text + text_of(m, "error") + '\n';
    text += c.ok ? cell(m, "ms_total", 2) + " ms" : "not timed";
    text += fmt::format(", {} judged", cell(m, "judged"));
    for (const char* key :
         {"missed", "spurious", "wrong_triangle", "inexact", "leaks", "differ"})
        if (number_of(m, key) > 0) text += fmt::format(", {} {}", cell(m, key), key);
    if (!c.ok) text += "; first: " + text_of(m, "why");
    return text + '\n';
}

}  // namespace bench::hits
