// accuracy_suite.hpp - rsh-bench accuracy: how far whole frames are from the truth, against the time that
// they take, along every axis on which one can be had for the other.
#pragma once

#include "suite.hpp"

namespace bench {

class AccuracySuite final : public Suite {
public:
    const char* name() const noexcept override { return "accuracy"; }
    const char* description() const noexcept override {
        return "Error of whole frames against time, along every way to trade one for the other";
    }
    void add_options(CLI::App& app) override;
    void run(const Run& run) override;

private:
    std::string filter_, pictures_;
    uint32_t width_ = 0;
    bool lists_ = false;
};

}  // namespace bench
