#include <fmt/format.h>

#include "table/members.hpp"
#include "table/sections.hpp"
#include "table/text_table.hpp"

namespace bench {
namespace {

using nlohmann::json;

std::string failures(const json& metrics) {
    const auto failed = metrics.find("failed");
    if (failed == metrics.end() || !failed->is_array()) return "";
    std::string text;
    for (const json& name : *failed)
        if (name.is_string()) text += "  FAILED: " + name.get<std::string>() + '\n';
    return text;
}

std::string lines_of(const json& c) {
    const json& metrics = c["metrics"];
    return wrapped(fmt::format("{}: {} passed, {} s", c["name"].get<std::string>(),
                               cell(metrics, "passed"), cell(metrics, "seconds"))) +
           failures(metrics);
}

}  // namespace

std::string tests_section(const std::vector<ResultFile>& files) {
    std::string text;
    for (const ResultFile& file : files)
        if (file.suite() == "tests")
            for (const json& c : file.cases()) text += lines_of(c);
    return text.empty() ? "" : "TESTS\n" + text;
}

}  // namespace bench
