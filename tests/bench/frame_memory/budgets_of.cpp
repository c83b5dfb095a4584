#include "frame_memory/budgets_of.hpp"

#include <fmt/format.h>

#include <optional>
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

namespace {

struct Refused {
    size_t budget, least;
};

std::optional<Refused> read(const std::string& refusal) {
    static const std::regex kPattern("budget: is ([0-9]+), must be 0 or at least ([0-9]+)$");
    std::smatch found;
    if (!std::regex_search(refusal, found, kPattern)) return std::nullopt;
    return Refused{std::stoull(found[1]), std::stoull(found[2])};
}

}  // namespace

size_t least_named_by(const std::string& refusal) {
    const std::optional<Refused> refused = read(refusal);
    if (!refused)
        throw std::runtime_error("a budget that is too small is refused by \"" + refusal +
                                 "\", which names no least one");
    return refused->least;
}

bool is_refusal_below(const std::string& refusal, size_t least) {
    const std::optional<Refused> refused = read(refusal);
    return refused && refused->budget + 1 == least && refused->least == least;
}

bool keeps_to(size_t allowed, size_t peak) {
    return peak > 0 && peak <= allowed;
}

}  // namespace bench::memory
