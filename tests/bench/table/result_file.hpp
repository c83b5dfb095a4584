// result_file.hpp - files of results, as the table needs them: of rsh-bench, or of GoogleTest
// (--gtest_output=json:FILE). What is missing, half written or something else is named, and does
// not keep the others from being read.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace bench {

struct ResultFile {
    std::string path;
    nlohmann::json json;  // of rsh-bench: each case has a name, "ok", params and metrics

    bool is_of_tests() const { return json.contains("testsuites"); }
    std::string suite() const { return json.value("suite", ""); }
    const nlohmann::json& cases() const { return json.at("cases"); }
};

struct ResultFiles {
    std::vector<ResultFile> read;
    std::vector<std::string> unread;  // "FILE: why"
};

ResultFiles read_result_files(const std::vector<std::string>& paths);

}  // namespace bench
