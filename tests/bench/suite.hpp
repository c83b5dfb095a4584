// suite.hpp - what every suite of rsh-bench is given and gives back. A suite is one folder here
// and one row in suites.cpp; parsing the command line, opening the device and writing the JSON
// are the program's business.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "device.hpp"

namespace bench {

// One measured case. Its answer was checked before it was timed; one that was wrong has
// ok = false and no metrics.
struct Case {
    std::string name;
    nlohmann::json params;
    nlohmann::json metrics;
    bool ok = true;
};

struct Run {
    const Device& device;
    bool quick;  // a minute at most
};

class Suite {
public:
    virtual ~Suite() = default;
    virtual const char* name() const noexcept = 0;  // of the subcommand
    virtual const char* description() const noexcept = 0;
    // Options of its own, beside --json, --quick and --device.
    virtual void add_options(CLI::App& app) = 0;
    virtual std::vector<Case> run(const Run& run) = 0;
};

const std::vector<Suite*>& suites();

}  // namespace bench
