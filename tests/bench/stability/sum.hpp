// sum.hpp - all cases as one, named stability/all.
#pragma once

#include "results.hpp"
#include "stability/totals.hpp"

namespace bench::stability {

// Faults, as all cases have them together; rays, pairs and decisions, each once; the hash of all
// hashes.
Case sum_of(const std::vector<Case>& cases, const Totals& totals);

}  // namespace bench::stability
