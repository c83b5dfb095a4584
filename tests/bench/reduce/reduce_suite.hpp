// reduce_suite.hpp - rsh-bench reduce: stream reduction, every strategy and its peers against a
// copy of the same bytes.
#pragma once

#include "reduce/selection.hpp"
#include "suite.hpp"

namespace bench {

class ReduceSuite final : public Suite {
public:
    const char* name() const noexcept override { return "reduce"; }
    const char* description() const noexcept override {
        return "Stream reduction: every strategy and its peers against a copy";
    }
    void add_options(CLI::App& app) override;
    void run(const Run& run) override;

private:
    void add_dump(CLI::App& app);

    ReduceOptions options_;
};

}  // namespace bench
