// mirror_cases.hpp - what paths between mirrors are in the JSON: a case per line and bounce, and one
// per line that sums it up.
#pragma once

#include "oracle/mirrors/lines.hpp"
#include "results.hpp"

namespace bench::mirrors {

// rsh may err so many times as much as the best floats, see oracle::times_the_best, while no more
// than a quarter of the best paths are lost. Later the median is one of the few paths that are about
// to be lost; there it only counts how soon half of all are.
constexpr double kMostTimesTheBest = 2;
constexpr double kComparedShare = 0.25;
constexpr double kLeastOfBestHalf = 0.9;

std::vector<Case> cases_of(const oracle::Followed& followed, bool is_smooth);

const char* name_of(oracle::Line line);
const char* name_of_normals(bool is_smooth);

}  // namespace bench::mirrors
