// summary.hpp - what the cases of rsh-bench paper say together, per engine. Judges nothing.
#pragma once

#include "results.hpp"

namespace bench::paper {

// One case per engine, of those that were right; its row is "summary". For the growth series `patio`,
// `less_coherent` and `statue`:
//   patio_ns_per_triangle   slope of ms over triangles
//   patio_exponent          of ms over triangles: 1 is linear
// and
//   pixels_exponent         of ms over pixels, 128x128 to the largest; below 1 is sub-linear
//   ms_per_batch            slope of ms over the batches that one scene was given in
//   occlusion_ratio         ms with the most sheets behind each other over that with one
//   build_share             most that the hierarchy over the rays took of ms, over the rows of the paper
//   least_speedup           of those rows, but `build`
// What no case measured is absent.
std::vector<Case> summarize(const std::vector<Case>& cases);

std::string as_text_of_summary(const Case& summary);

}  // namespace bench::paper
