// approximate_suite.hpp - rsh-bench approximate: what a tolerance saves, and what it does to the picture.
#pragma once

#include "suite.hpp"

namespace bench {

class ApproximateSuite final : public Suite {
public:
    const char* name() const noexcept override { return "approximate"; }
    const char* description() const noexcept override {
        return "Time and error of approximate frames beside exact ones of the same size";
    }
    void add_options(CLI::App& app) override;
    void run(const Run& run) override;

private:
    std::string filter_;
    bool lists_ = false;
};

}  // namespace bench
