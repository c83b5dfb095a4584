#include "budgets/measured_program.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "budgets/bound.hpp"
#include "programs/library_programs.hpp"

namespace bench::budgets {
namespace {

std::string text_of(const std::string& name) {
    const std::string path = std::string(RSH_BUDGET_KERNELS) + '/' + name;
    std::ifstream file(path);
    std::stringstream text;
    if (!(text << file.rdbuf())) throw std::runtime_error("cannot read " + path);
    return fmt::format("#line 1 \"{}\"\n{}\n", name, text.str());
}

std::string source_of(const std::string& file, bool is_rough) {
    std::string library;
    for (const char* stem : stems_of(file)) library += program_source(stem);
    for (const Change& change : changes_of(file))
        if (is_rough || change.is_always) library = replaced(library, change.from, change.to);
    return text_of("rough.h") + library + text_of("search.h") + text_of("wide.h") +
           text_of("aimed.h") + text_of(file + ".cl");
}

}  // namespace

cl::Program measured_program(const Device& device, const std::string& file, bool is_rough) {
    cl::Program program(device.context(), source_of(file, is_rough));
    const std::string options = base_options(device.device()(), 1);
    try {
        program.build({device.device()}, options.c_str());
    } catch (const cl::BuildError& error) {
        const auto logs = error.getBuildLog();
        throw std::runtime_error(
            fmt::format("{}: {}", file, logs.empty() ? error.what() : logs.front().second));
    }
    return program;
}

}  // namespace bench::budgets
