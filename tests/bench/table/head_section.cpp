#include <fmt/format.h>

#include <algorithm>

#include "table/members.hpp"
#include "table/sections.hpp"
#include "table/text_table.hpp"

namespace bench {
namespace {

using nlohmann::json;

std::string memory_of(const json& device) {
    const double bytes = number_of(device, "memory_bytes");
    return bytes > 0 ? fmt::format("{:.1f} GiB", bytes / (1 << 30)) : "-";
}

std::string device_text(const json& device) {
    return wrapped(fmt::format("device: {}, {} compute units, {}", text_of(device, "name"),
                               cell(device, "compute_units"), memory_of(device))) +
           wrapped(fmt::format("host: {}, {} threads", text_of(device, "host_instruction_set"),
                               cell(device, "host_threads"))) +
           wrapped(fmt::format("driver: {}, {}; platform: {}, {}", text_of(device, "driver"),
                               text_of(device, "version"), text_of(device, "platform"),
                               text_of(device, "platform_version")));
}

std::string library_text(const json& rsh) {
    return wrapped(
        fmt::format("rsh {}, commit {}", text_of(rsh, "version"), text_of(rsh, "commit")));
}

void add_once(std::vector<std::string>& texts, const std::string& text) {
    if (std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(text);
}

}  // namespace

std::string head_section(const std::vector<ResultFile>& files) {
    std::vector<std::string> texts;
    for (const char* member : {"device", "rsh"})
        for (const ResultFile& file : files) {
            const auto found = file.json.find(member);
            if (found == file.json.end() || !found->is_object()) continue;
            add_once(texts, *member == 'd' ? device_text(*found) : library_text(*found));
        }
    std::string head;
    for (const std::string& text : texts) head += text;
    return head;
}

}  // namespace bench
