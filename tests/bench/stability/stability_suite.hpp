// stability_suite.hpp - rsh-bench stability: does every engine find the right hits where floats
// make it hard. Times nothing.
#pragma once

#include "suite.hpp"

namespace bench {

class StabilitySuite final : public Suite {
public:
    const char* name() const noexcept override { return "stability"; }
    const char* description() const noexcept override {
        return "Hits of every engine on stiff and extreme scenes, against exact oracles";
    }
    void add_options(CLI::App& app) override;
    void run(const Run& run) override;

private:
    std::string filter_;
    cl_uint vector_width_ = 0;
    bool is_full_ = false, is_hundredth_ = false;
    bool lists_ = false;
};

}  // namespace bench
