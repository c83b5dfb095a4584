// results.hpp - what a suite hands over as soon as it has it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace bench {

// One measured case. Its answer was checked before it was timed; one that was wrong has
// ok = false and no metrics of time.
struct Case {
    std::string name;
    nlohmann::json params;
    nlohmann::json metrics;
    bool ok = true;
};

class Results {
public:
    virtual ~Results() = default;
    virtual void add(const Case& c) = 0;
    virtual void leave_out(const std::string& name, const std::string& why) = 0;

    // All there are, in the order in which they came.
    virtual const std::vector<Case>& cases() const = 0;
};

}  // namespace bench
