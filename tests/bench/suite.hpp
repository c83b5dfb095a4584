// suite.hpp - what every suite of rsh-bench is given and hands over. A suite is one folder here
// and one row in suites.cpp; parsing the command line, opening the device and writing the JSON
// are the program's business.
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "device.hpp"
#include "limit.hpp"
#include "results.hpp"

namespace bench {

struct Run {
    const Device& device;
    bool quick;  // a minute at most
    const Limit&
        limit;         // a case that would begin after it, or end after it by far, is left out
    Results& results;  // cases, each as soon as it is finished, and what was left out
};

class Suite {
public:
    virtual ~Suite() = default;
    virtual const char* name() const noexcept = 0;  // of the subcommand
    virtual const char* description() const noexcept = 0;
    // Options of its own, beside --json, --quick, --limit and --device.
    virtual void add_options(CLI::App& app) = 0;
    // Before anything of OpenCL is called.
    virtual void prepare() {}
    virtual void run(const Run& run) = 0;
};

const std::vector<Suite*>& suites();

}  // namespace bench
