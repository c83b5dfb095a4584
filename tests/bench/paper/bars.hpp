// bars.hpp - how much quicker than the paper a row has to be. The suite says so, and judges no case by it: a
// slow machine is no wrong answer.
#pragma once

#include <string>
#include <vector>

#include "results.hpp"

namespace bench::paper {

struct Bar {
    std::string what;  // "ms is 3.95, must be at most 7.90 (a 10th of the paper's 79)"
    bool holds;
};

// Of the engine `tiles`; none of other engines, of rows that the paper gives no time for, and of cases that
// are wrong.
std::vector<Bar> bars(const Case& c);

}  // namespace bench::paper
