#include <fmt/format.h>

#include "table/members.hpp"
#include "table/sections.hpp"
#include "table/text_table.hpp"

namespace bench {
namespace {

using nlohmann::json;

struct Tally {
    size_t passed = 0, skipped = 0;
    std::vector<std::string> failed;
};

void count(const json& suite, Tally& tally) {
    for (const json& test : suite.at("testsuite")) {
        const std::string result = text_of(test, "result");
        if (test.contains("failures"))
            tally.failed.push_back(text_of(suite, "name") + '.' + text_of(test, "name"));
        else if (result == "COMPLETED")
            ++tally.passed;
        else if (result == "SKIPPED")
            ++tally.skipped;
    }
}

Tally tally_of(const ResultFile& file) {
    Tally tally;
    for (const json& suite : file.json.at("testsuites")) count(suite, tally);
    return tally;
}

std::string line_of(const ResultFile& file) {
    const Tally tally = tally_of(file);
    std::string text = wrapped(fmt::format("{}: {} passed, {} failed, {} skipped", file.path,
                                           tally.passed, tally.failed.size(), tally.skipped));
    for (const std::string& name : tally.failed) text += "  FAILED: " + name + '\n';
    if (tally.passed + tally.failed.size() == 0) text += "  NO TEST RAN\n";
    return text;
}

}  // namespace

std::string tests_section(const std::vector<ResultFile>& files) {
    std::string text;
    for (const ResultFile& file : files)
        if (file.is_of_tests()) text += line_of(file);
    return text.empty() ? "" : "TESTS\n" + text;
}

bool have_tests_passed(const ResultFile& file) {
    const Tally tally = tally_of(file);
    return tally.failed.empty() && tally.passed > 0;
}

}  // namespace bench
