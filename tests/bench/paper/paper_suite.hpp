// paper_suite.hpp - rsh-bench paper: every figure of the paper's talk, and ours beside it.
#pragma once

#include "suite.hpp"

namespace bench {

class PaperSuite final : public Suite {
public:
    const char* name() const noexcept override { return "paper"; }
    const char* description() const noexcept override {
        return "The figures of the paper's talk, each with ours beside it";
    }
    void add_options(CLI::App& app) override;
    void run(const Run& run) override;

private:
    std::string filter_;
    bool lists_ = false;
};

}  // namespace bench
