// programs_suite.hpp - rsh-bench programs: compiles every program with every set of options that
// the library's tests ask for.
#pragma once

#include "suite.hpp"

namespace bench {

class ProgramsSuite final : public Suite {
public:
    const char* name() const noexcept override { return "programs"; }
    const char* description() const noexcept override {
        return "Compiles every program: seconds, and what each kernel takes";
    }
    void add_options(CLI::App& app) override;
    void run(const Run& run) override;

private:
    std::string list_ = RSH_PROGRAM_LIST;
    std::string filter_;
    cl_uint vector_width_ = 0;
};

}  // namespace bench
