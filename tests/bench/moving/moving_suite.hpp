// moving_suite.hpp - rsh-bench moving: what a frame costs where most of the scene stands still, and
// whether frames of a scene that moves as a whole keep the program's memory as it is.
#pragma once

#include "suite.hpp"

namespace bench {

class MovingSuite final : public Suite {
public:
    const char* name() const noexcept override { return "moving"; }
    const char* description() const noexcept override {
        return "Bounds that leave alone what stands still, and memory over many frames";
    }
    void add_options(CLI::App&) override {}
    void run(const Run& run) override;
};

}  // namespace bench
