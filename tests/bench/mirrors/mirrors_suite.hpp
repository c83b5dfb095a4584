// mirrors_suite.hpp - rsh-bench mirrors: how far rays between curved mirrors are from their path,
// bounce by bounce, and how far they would be by the best that floats can do. Times nothing.
#pragma once

#include "suite.hpp"

namespace bench {

class MirrorsSuite final : public Suite {
public:
    const char* name() const noexcept override { return "mirrors"; }
    const char* description() const noexcept override {
        return "Errors of rays between curved mirrors, 1 to 64 bounces, beside 113 bits";
    }
    void add_options(CLI::App&) override {}
    void run(const Run& run) override;
};

}  // namespace bench
