#include "programs/programs_suite.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <regex>
#include <set>
#include <stdexcept>

#include "programs/compile.hpp"

namespace bench {
namespace {

using nlohmann::json;

std::vector<ProgramName> read_list(const std::string& path) {
    errno = 0;
    std::ifstream file(path);
    if (!file)
        throw std::runtime_error(fmt::format("--list: {}: {}", path, std::strerror(errno)));
    std::vector<ProgramName> names = read_program_list(file);
    if (names.empty())
        throw std::runtime_error(fmt::format("--list: {} names no program", path));
    return names;
}

// The first of each stem: a list has them before the others.
std::vector<ProgramName> only_first(const std::vector<ProgramName>& names) {
    std::vector<ProgramName> first;
    std::set<std::string> stems;
    for (const ProgramName& name : names)
        if (stems.insert(name.stem).second) first.push_back(name);
    return first;
}

std::string case_name(const ProgramName& name) {
    return "programs/" + name.text();
}

Case measure(const Compiler& compiler, const ProgramName& name) {
    const json params = {
        {"program", name.stem}, {"options", name.options}, {"vector_width", compiler.width()}};
    const json metrics = compiler.compile(name);
    return {case_name(name), params, metrics, metrics.contains("seconds")};
}

void print(const Case& c) {
    if (c.ok)
        fmt::print("{}: {:.2f} s, {} kernels\n", c.name, c.metrics["seconds"].get<double>(),
                   c.metrics["kernels"].size());
    else
        fmt::print("{}: does not compile: {}\n", c.name, c.metrics["error"].get<std::string>());
    std::fflush(stdout);
}

}  // namespace

void ProgramsSuite::add_options(CLI::App& app) {
    app.add_option("--list", list_, "File with a line STEM OPTION... for each program");
    app.add_option("--filter", filter_, "Only cases whose name has a match of this expression");
    app.add_option("--vector-width", vector_width_, "To compile for: 1 shows what GPUs get")
        ->check(CLI::IsMember({1, 4, 8, 16}));
}

void ProgramsSuite::run(const Run& run) {
    const std::vector<ProgramName> all = read_list(list_);
    const std::regex wanted(filter_.empty() ? "." : filter_);
    const Compiler compiler(run.device, vector_width_);
    for (const ProgramName& name : run.quick ? only_first(all) : all) {
        if (!std::regex_search(case_name(name), wanted)) continue;
        if (run.limit.has_passed()) {
            run.results.leave_out(case_name(name), run.limit.when_passed());
            continue;
        }
        const Case result = measure(compiler, name);
        print(result);
        run.results.add(result);
    }
}

}  // namespace bench
