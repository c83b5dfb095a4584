#include "frame_memory/budgets_of.hpp"

#include <fmt/format.h>

#include <regex>
#include <stdexcept>

namespace bench::memory {

std::vector<Budget> budgets_from(size_t least, size_t whole, size_t factor) {
    std::vector<Budget> all = {{"least", least}};
    for (size_t times = factor; times < whole / least; times *= factor)
        all.push_back({fmt::format("{}x", times), times * least});
    if (whole > least) all.push_back({"whole", whole});
    return all;
}

size_t least_named_by(const std::string& refusal) {
    static const std::regex kPattern("budget: is [0-9]+, must be 0 or at least ([0-9]+)");
    std::smatch found;
    if (!std::regex_search(refusal, found, kPattern))
        throw std::runtime_error("a budget that is too small is refused by \"" + refusal +
                                 "\", which names no least one");
    return std::stoull(found[1]);
}

}  // namespace bench::memory
