// limit.hpp - how long a suite may run: what would begin after that is left out, and so is what
// would end after it, by what smaller cases took.
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace bench {

class Limit {
public:
    // Starts now. 0: there is none.
    explicit Limit(double seconds) : seconds_(seconds), start_(Clock::now()) {}

    bool has_passed() const { return left() <= 0; }
    double left() const;  // seconds; infinite without a limit
    // Why a case is left out.
    std::string when_passed() const;
    std::string when_too_long() const;

private:
    using Clock = std::chrono::steady_clock;
    double seconds_;
    Clock::time_point start_;
};

// What a case takes, from what the contender's last one took.
class Estimate {
public:
    // `work`: elements, or whatever a case's time grows with.
    void add(const std::string& contender, double work, double seconds);

    // Why a case must not begin; empty: it may. Unknown contenders may.
    std::string refusal(const Limit& limit, const std::string& contender, double work) const;

private:
    struct Taken {
        double work, seconds;
    };
    std::map<std::string, Taken> taken_;
};

}  // namespace bench
