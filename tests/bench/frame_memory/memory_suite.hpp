// memory_suite.hpp - rsh-bench memory: what a budget of memory costs, from the least possible one upward.
#pragma once

#include "suite.hpp"

namespace bench {

class MemorySuite final : public Suite {
public:
    const char* name() const noexcept override { return "memory"; }
    const char* description() const noexcept override {
        return "Budgets of memory: time, bytes that are allocated at once, the same bits";
    }
    void add_options(CLI::App& app) override;
    void prepare() override;
    void run(const Run& run) override;

private:
    std::string filter_;
    bool lists_ = false;
};

}  // namespace bench
