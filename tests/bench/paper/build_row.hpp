// build_row.hpp - the row `build`: the hierarchy over the reflections of 1 M pixels.
#pragma once

#include <string>
#include <vector>

#include "suite.hpp"

namespace bench::paper {

std::string build_case_name(const std::string& engine);

// A case per engine, each with the shape of nodes that it takes; measured as rsh-bench frame does it.
void measure_builds(const Run& run, const std::vector<std::string>& engines, size_t pairs);

}  // namespace bench::paper
