#include <fmt/format.h>

#include <regex>

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

void add_rows(TextTable& table, const json& c) {
    const json &params = c["params"], &metrics = c["metrics"];
    table.add_caption(fmt::format(
        "{}{}: {}", text_of(params, "program"), short_options(text_of(params, "options", "")),
        c["ok"].get<bool>() ? cell(metrics, "seconds", 2) + " s" : "WRONG"));
    const auto kernels = metrics.find("kernels");
    if (kernels == metrics.end() || !kernels->is_array()) return;
    for (const json& kernel : *kernels)
        if (kernel.is_object()) table.add(kernel_row(kernel));
}

}  // namespace

std::string programs_section(const std::vector<ResultFile>& files) {
    TextTable table(
        {"program, its kernels", "regs", "spill", "stack", "local", "private", "group", "step"},
        1);
    for (const ResultFile& file : files)
        if (file.suite() == "programs")
            for (const json& c : file.cases()) add_rows(table, c);
    if (table.is_empty()) return "";
    return "PROGRAMS: seconds to compile; registers of a work-item; bytes of spills, of stack, "
           "of\n"
           "local and private memory; largest group, and the step of its size\n" +
           table.text();
}

}  // namespace bench
