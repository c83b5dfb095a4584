#include "table/result_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace bench {
namespace {

using nlohmann::json;

void require(bool is_so, const std::string& why) {
    if (!is_so) throw std::runtime_error(why);
}

// A case without metrics has null there: from here on all have objects.
void check_case(json& c) {
    require(c.is_object() && c.contains("name") && c["name"].is_string(),
            fmt::format("a case has no name: {}", c.dump().substr(0, 60)));
    require(c.contains("ok") && c["ok"].is_boolean(),
            fmt::format("case {} does not say whether it is ok", c["name"].get<std::string>()));
    for (const char* member : {"params", "metrics"}) {
        if (!c.contains(member) || c[member].is_null()) c[member] = json::object();
        require(c[member].is_object(),
                fmt::format("case {}: {} is no object", c["name"].get<std::string>(), member));
    }
}

void check(json& document) {
    require(document.is_object(), "is no JSON object");
    require(document.contains("suite") && document["suite"].is_string() &&
                document.contains("cases") && document["cases"].is_array(),
            "is not of rsh-bench: has no suite, or no cases");
    for (json& c : document["cases"]) check_case(c);
    for (const char* member : {"device", "rsh"})
        require(!document.contains(member) || document[member].is_object(),
                fmt::format("{} is no object", member));
    const json left_out = document.value("left_out", json::array());
    require(!document["cases"].empty() || !left_out.empty(), "holds no case, none left out");
    for (const json& one : left_out)
        require(one.is_object(), "left_out holds something else than objects");
}

json read(const std::string& path) {
    errno = 0;
    std::ifstream file(path);
    require(file.is_open(), std::strerror(errno));
    json document = json::parse(file);
    check(document);
    return document;
}

}  // namespace

ResultFiles read_result_files(const std::vector<std::string>& paths) {
    ResultFiles files;
    for (const std::string& path : paths) {
        try {
            files.read.push_back({path, read(path)});
        } catch (const std::exception& error) {
            files.unread.push_back(fmt::format("{}: {}", path, error.what()));
        }
    }
    return files;
}

}  // namespace bench
