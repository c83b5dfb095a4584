#include <fmt/format.h>

#include <regex>
#include <set>

#include "table/members.hpp"
#include "table/sections.hpp"
#include "table/text_table.hpp"

namespace bench {
namespace {

using nlohmann::json;

std::string short_options(const std::string& options) {
    static const std::regex define("-D *(RSH_)?");
    return (options.empty() ? "" : " ") + std::regex_replace(options, define, "");
}

TextTable::Row kernel_row(const json& kernel) {
    return {"  " + text_of(kernel, "name"), cell(kernel, "registers"),
            cell(kernel, "spill_bytes"),    cell(kernel, "stack_bytes"),
            cell(kernel, "local_bytes"),    cell(kernel, "private_bytes"),
            cell(kernel, "group_size"),     cell(kernel, "group_multiple")};
}

// Most sets of options change no figure of a kernel: what was shown before is only counted.
class Programs {
public:
    void add(const json& c) {
        const json &params = c["params"], &metrics = c["metrics"];
        std::vector<TextTable::Row> rows;
        size_t known = 0;
        for (const json& kernel : metrics.value("kernels", json::array())) {
            if (!kernel.is_object()) continue;
            const TextTable::Row row = kernel_row(kernel);
            if (shown_.insert(row).second)
                rows.push_back(row);
            else
                ++known;
        }
        table_.add_caption(
            fmt::format("{}{}: {}{}", text_of(params, "program"),
                        short_options(text_of(params, "options", "")),
                        c["ok"].get<bool>() ? cell(metrics, "seconds", 2) + " s" : "WRONG",
                        known > 0 ? fmt::format(", {} kernels as above", known) : ""));
        for (const TextTable::Row& row : rows) table_.add(row);
    }
    bool is_empty() const { return table_.is_empty(); }
    std::string text() const { return table_.text(); }

private:
    TextTable table_ = {
        {"program, its kernels", "regs", "spill", "stack", "local", "private", "group", "step"},
        1};
    std::set<TextTable::Row> shown_;
};

}  // namespace

std::string programs_section(const std::vector<ResultFile>& files) {
    Programs programs;
    for (const ResultFile& file : files)
        if (file.suite() == "programs")
            for (const json& c : file.cases()) programs.add(c);
    if (programs.is_empty()) return "";
    return "PROGRAMS: seconds to compile; registers of a work-item; bytes of spills, of stack, "
           "of\n"
           "local and private memory; largest group, and the step of its size\n" +
           programs.text();
}

}  // namespace bench
