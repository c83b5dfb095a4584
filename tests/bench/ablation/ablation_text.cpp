#include "ablation/ablation_text.hpp"

#include <fmt/format.h>

#include "table/members.hpp"

namespace bench::ablation {

std::string as_text(const Case& c) {
    const nlohmann::json& m = c.metrics;
    std::string text = c.name + ": ";
    if (m.contains("error")) return text + text_of(m, "error") + '\n';
    text += c.ok ? fmt::format("{} ms ({})", cell(m, "ms", 2), cell(m, "ratio", 3))
                 : "wrong, not timed";
    return text + fmt::format(", {} bytes, {} launches, {} programs compiled in {} ms\n",
                              cell(m, "bytes"), cell(m, "launches"), cell(m, "programs"),
                              cell(m, "compile_ms", 0));
}

}  // namespace bench::ablation
