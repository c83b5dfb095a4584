// strategies.hpp - the strategies that the library names: a new one is tested without a word
// in any test.
#pragma once

#include <string>
#include <vector>

#include <rsh/rsh.h>

#include "support/not_empty.hpp"

namespace test {

inline std::vector<cl_uint> all_strategies() {
    std::vector<cl_uint> all;
    for (cl_uint id = 1; rsh_strategy_name(id); ++id) all.push_back(id);
    return not_empty(all, "strategies");
}

// "default" or its name.
inline std::string strategy_name(cl_uint strategy) {
    const char* name = rsh_strategy_name(strategy);
    return name ? name : "default";
}

}  // namespace test
