// ablation_suite.hpp - rsh-bench ablation: what each feature costs that a scene does not have, left out and
// compiled in, and that it has.
#pragma once

#include "suite.hpp"

namespace bench {

class AblationSuite final : public Suite {
public:
    const char* name() const noexcept override { return "ablation"; }
    const char* description() const noexcept override {
        return "Time, memory, launches and compilation of each feature: left out, compiled in, "
               "used";
    }
    void add_options(CLI::App& app) override;
    void run(const Run& run) override;

private:
    std::string filter_;
    bool lists_ = false;
};

}  // namespace bench
