// queries_suite.hpp - rsh-bench queries: what it takes to count or to list all hits, over what the
// closest ones take.
#pragma once

#include "suite.hpp"

namespace bench {

class QueriesSuite final : public Suite {
public:
    const char* name() const noexcept override { return "queries"; }
    const char* description() const noexcept override {
        return "Time of any, count and all over that of closest, where rays cross four "
               "surfaces";
    }
    void add_options(CLI::App& app) override;
    void run(const Run& run) override;

private:
    std::string filter_;
};

}  // namespace bench
