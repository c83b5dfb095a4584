// measure.hpp - one call on one scene with one engine: with every budget its bytes are counted and its
// answer is compared, then all budgets are timed in turn.
#pragma once

#include <vector>

#include "frame_memory/budgeted_call.hpp"
#include "suite.hpp"

namespace bench::memory {

struct Amount {
    double seconds;  // of timed rounds per subject, about
    size_t rounds;   // at most
};

struct Subject {
    std::string call, scene, engine;
    Size size;
    nlohmann::json params;  // beside these
    size_t factor;          // from budget to budget

    std::string case_name(const std::string& budget) const;
};

// What every budget has to give: the answer of the first engine of a call on a scene, without a budget.
using Expected = std::vector<Record>;

// Empty: then it becomes the answer without a budget.
void measure(const Run& run, const Subject& subject, BudgetedCall& call, const Amount& amount,
             Expected& expected);

}  // namespace bench::memory
