// hits_suite.hpp - rsh-bench hits: how many hits are wrong, against the time that they take: rsh's
// engines and Embree, default and robust, on the same rays of ordinary and of hostile scenes.
#pragma once

#include "suite.hpp"

namespace bench {

class HitsSuite final : public Suite {
public:
    const char* name() const noexcept override { return "hits"; }
    const char* description() const noexcept override {
        return "Wrong hits against time, of every engine and of Embree, by an exact oracle";
    }
    void add_options(CLI::App& app) override;
    void run(const Run& run) override;

private:
    std::string filter_;
    uint32_t side_ = 0, triangles_ = 0;
    bool lists_ = false;
};

}  // namespace bench
