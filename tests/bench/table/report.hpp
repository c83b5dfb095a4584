// report.hpp - rsh-bench table FILE...: one text report, at most 100 columns wide, of what
// rsh-bench and GoogleTest wrote. Measures nothing and needs no device.
#pragma once

#include <string>
#include <vector>

namespace bench {

struct Report {
    std::string text;
    bool is_good;  // every file was read, every case is right, every test passed
};

Report make_report(const std::vector<std::string>& paths);

}  // namespace bench
