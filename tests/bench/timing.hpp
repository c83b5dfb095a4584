// timing.hpp - paired, interleaved timing: A B A B ..., so that whatever slows the machine down
// for a while slows both. A ratio is taken per pair; medians and quartiles are reported.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace bench {

struct Spread {
    double median = 0, low = 0, high = 0;  // low, high: the quartiles
};

Spread spread(std::vector<double> values);

// Milliseconds that `work` takes. Work that enqueues must wait for its end.
double milliseconds(const std::function<void()>& work);

// Workers of a thread pool spin for a while after their last task. Whoever comes next must not
// share the cores with them.
void let_threads_sleep();

class PairedTimes {
public:
    // Runs `base`, then `work`, once each, and keeps both times. Returns that of `work`, in
    // seconds.
    double run_pair(const std::function<void()>& base, const std::function<void()>& work);

    // Pairs until `budget_ms` is used up: at least 3, at most `most`. A pair goes first that is
    // not kept.
    void run_series(const std::function<void()>& base, const std::function<void()>& work,
                    double budget_ms, size_t most);

    Spread base_ms() const { return spread(base_); }
    Spread work_ms() const { return spread(work_); }
    Spread ratio() const;  // base over work: above 1, work is the quicker one
    size_t pairs() const { return work_.size(); }

private:
    std::vector<double> base_;
    std::vector<double> work_;
};

}  // namespace bench
