// budgets_suite.hpp - rsh-bench budgets: does each error bound hold, and how much of it is used.
// Times nothing.
#pragma once

#include "suite.hpp"

namespace bench {

class BudgetsSuite final : public Suite {
public:
    const char* name() const noexcept override { return "budgets"; }
    const char* description() const noexcept override {
        return "The derived error bounds beside the largest errors that a search finds";
    }
    void add_options(CLI::App& app) override;
    void run(const Run& run) override;

private:
    std::string filter_;
    uint64_t evaluations_ = 0;
    bool lists_ = false;
};

}  // namespace bench
