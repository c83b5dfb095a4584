// batches_rows.hpp - rows of scenes that come in batches of triangles (rsh_batch_source), with the engine
// tiles:
//   batches        a scene in 1 to 64 batches: what a batch costs
//   large_batches  the 2.3 million triangles of the row `large` in 50 batches, as in the paper
//   out_of_core    20 million triangles, never held anywhere, in little memory
#pragma once

#include <string>
#include <vector>

#include "paper/measure.hpp"

namespace bench::paper {

// Of all these rows; with `quick` of those that --quick runs.
std::vector<std::string> batches_case_names(bool quick);

// Those that are named, of all rows but out_of_core.
void measure_batches(const Run& run, const std::vector<std::string>& names,
                     const Amount& amount);
// Before other rows but `build`: they make the process large.
void measure_out_of_core(const Run& run, const std::vector<std::string>& names);

}  // namespace bench::paper
