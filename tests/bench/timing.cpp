#include "timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace bench {
namespace {

double quantile(const std::vector<double>& sorted, double q) {
    const double at = q * double(sorted.size() - 1);
    const size_t below = size_t(at);
    const size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (at - std::floor(at)) * (sorted[above] - sorted[below]);
}

}  // namespace

Spread spread(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    return {quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75)};
}

double milliseconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> passed =
        std::chrono::steady_clock::now() - start;
    return passed.count();
}

void let_threads_sleep() {
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
}

double PairedTimes::run_pair(const std::function<void()>& base,
                             const std::function<void()>& work) {
    base_.push_back(milliseconds(base));
    work_.push_back(milliseconds(work));
    return work_.back() * 1e-3;
}

void PairedTimes::run_series(const std::function<void()>& base,
                             const std::function<void()>& work, double budget_ms, size_t most) {
    double used = milliseconds(base) + milliseconds(work);
    while (pairs() < 3 || (pairs() < most && used < budget_ms)) {
        run_pair(base, work);
        used += base_.back() + work_.back();
    }
}

Spread PairedTimes::ratio() const {
    std::vector<double> ratios;
    for (size_t i = 0; i < work_.size(); ++i) ratios.push_back(base_[i] / work_[i]);
    return spread(ratios);
}

}  // namespace bench
