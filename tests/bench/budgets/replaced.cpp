#include <fmt/format.h>

#include <stdexcept>

#include "budgets/measured_program.hpp"

namespace bench::budgets {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    size_t at = text.find(from);
    if (at == std::string::npos)
        throw std::runtime_error(fmt::format("the library's kernels have no \"{}\"", from));
    for (; at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

}  // namespace bench::budgets
