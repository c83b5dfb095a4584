// reduce_suite.hpp - rsh-bench reduce: stream reduction, every strategy against a copy.
#pragma once

#include "suite.hpp"

namespace bench {

class ReduceSuite final : public Suite {
public:
    const char* name() const noexcept override { return "reduce"; }
    const char* description() const noexcept override {
        return "Stream reduction: every strategy against a copy";
    }
    void add_options(CLI::App& app) override;
    std::vector<Case> run(const Run& run) override;
};

}  // namespace bench
