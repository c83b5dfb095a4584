// frame_summary.hpp - what the cases of rsh-bench frame say together, per engine and bound.
// Judges nothing.
#pragma once

#include "results.hpp"

namespace bench {

// One case per column, of those cases that were right. Ratios are geometric means over
// reflection, refraction and shadow rays at 512x512 and 1024x1024, with at least 20,000 and
// 300,000 triangles, and the least of them; higher is better:
//   ratio_embree, ratio_embree_300k, ratio_embree_least  against Embree's best rebuild + trace
//   ratio_refit, ratio_refit_300k, ratio_refit_least     against its refit + trace
//   ratio_series_least                                   against rebuild, at other sizes
//   ratio_diffuse, ratio_second                          against rebuild, of those rays
// Lower is better:
//   ns_per_triangle   slope over the mirror floors of 80,000 triangles and more, 512x512
//   pixels_exponent   over the mirror floor of 80,000 triangles, 128x128 to 2048x2048
//   build_over_copy   the slowest hierarchy build of 1 M rays over a copy of their bytes
//   bytes_over_bound  most memory, in units of 64 bytes per ray + 64 bytes per triangle
// Against paper_faithful on the same rows, from 80,000 triangles; higher is better:
//   fewer_tests, quicker_700k   the least ratio
// What no case measured is absent.
std::vector<Case> summarize(const std::vector<Case>& cases);

// A few lines for a terminal.
std::string as_text(const Case& summary);

}  // namespace bench
