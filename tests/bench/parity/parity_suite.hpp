// parity_suite.hpp - rsh-bench parity: is a point inside a closed mesh if its ray crosses an odd number
// of triangles. Times nothing.
#pragma once

#include "suite.hpp"

namespace bench {

class ParitySuite final : public Suite {
public:
    const char* name() const noexcept override { return "parity"; }
    const char* description() const noexcept override {
        return "Inside or outside of closed meshes by counts, against solid angles";
    }
    void add_options(CLI::App& app) override;
    void run(const Run& run) override;

private:
    std::string filter_;
    uint32_t random_ = 0, chosen_ = 0;
};

}  // namespace bench
