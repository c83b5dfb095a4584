// limit.cpp - a case of twice the work takes twice the time, or less.
#include "limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace bench {

double Limit::left() const {
    if (!(seconds_ > 0)) return std::numeric_limits<double>::infinity();
    return seconds_ - std::chrono::duration<double>(Clock::now() - start_).count();
}

std::string Limit::when_passed() const {
    return fmt::format("the limit of {:g} s has passed", seconds_);
}

std::string Limit::when_too_long() const {
    return fmt::format("would not end within the limit of {:g} s", seconds_);
}

void Estimate::add(const std::string& contender, double work, double seconds) {
    taken_[contender] = {work, seconds};
}

std::string Estimate::refusal(const Limit& limit, const std::string& contender,
                              double work) const {
    if (limit.has_passed()) return limit.when_passed();
    const auto last = taken_.find(contender);
    if (last == taken_.end()) return {};
    const double seconds =
        last->second.seconds * std::max(1.0, work / std::max(1.0, last->second.work));
    return seconds <= limit.left() ? "" : limit.when_too_long();
}

}  // namespace bench
