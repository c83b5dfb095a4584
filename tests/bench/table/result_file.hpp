// result_file.hpp - files of results, as the table needs them. What is missing, half written or
// something else is named, and does not keep the others from being read.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace bench {

struct ResultFile {
    std::string path;
    nlohmann::json json;  // each case has a name, "ok", params and metrics

    std::string suite() const { return json.value("suite", ""); }
    const nlohmann::json& cases() const { return json.at("cases"); }
};

struct ResultFiles {
    std::vector<ResultFile> read;
    std::vector<std::string> unread;  // "FILE: why"
};

ResultFiles read_result_files(const std::vector<std::string>& paths);

}  // namespace bench
