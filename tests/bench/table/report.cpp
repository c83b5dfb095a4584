#include "table/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "left_out.hpp"
#include "table/members.hpp"
#include "table/sections.hpp"
#include "table/text_table.hpp"

namespace bench {
namespace {

using nlohmann::json;

std::string left_out_section(const std::vector<ResultFile>& files) {
    std::string text;
    for (const ResultFile& file : files) {
        const auto found = file.json.find("left_out");
        if (found != file.json.end()) text += left_out_text(*found);
    }
    return text.empty() ? "" : "LEFT OUT\n" + text;
}

std::string reason(const json& metrics) {
    std::string text;
    for (const char* key : {"why", "error"}) text += text_of(metrics, key, "");
    return text.empty() ? "" : ": " + text;
}

std::string wrong_section(const std::vector<ResultFile>& files) {
    std::string text;
    for (const ResultFile& file : files)
        for (const json& c : file.cases())
            if (!c["ok"].get<bool>())
                text +=
                    wrapped("WRONG: " + c["name"].get<std::string>() + reason(c["metrics"]));
    return text;
}

bool is_good(const ResultFile& file) {
    return std::all_of(file.cases().begin(), file.cases().end(),
                       [](const json& c) { return c["ok"].get<bool>(); });
}

}  // namespace

Report make_report(const std::vector<std::string>& paths) {
    const ResultFiles files = read_result_files(paths);
    std::string unread;
    for (const std::string& one : files.unread) unread += wrapped("NOT READ: " + one);
    std::string text;
    for (const std::string& section :
         {head_section(files.read), tests_section(files.read), programs_section(files.read),
          reduce_section(files.read), frame_section(files.read), stability_section(files.read),
          hits_section(files.read), left_out_section(files.read), unread,
          wrong_section(files.read)})
        if (!section.empty()) text += (text.empty() ? "" : "\n") + section;
    return {text,
            files.unread.empty() && std::all_of(files.read.begin(), files.read.end(), is_good)};
}

}  // namespace bench
