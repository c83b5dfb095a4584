// report.hpp - rsh-bench table FILE...: one text report, at most 100 columns wide, of what
// suites wrote. Measures nothing and needs no device.
#pragma once

#include <string>
#include <vector>

namespace bench {

struct Report {
    std::string text;
    bool is_good;  // every file was read, every case is right
};

Report make_report(const std::vector<std::string>& paths);

}  // namespace bench
