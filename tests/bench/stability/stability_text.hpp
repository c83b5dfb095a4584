// stability_text.hpp - cases of rsh-bench stability as text.
#pragma once

#include <string>
#include <vector>

#include "results.hpp"

namespace bench::stability {

// One line.
std::string as_text(const Case& c);

// A row per family: what the oracle decided, the faults of all its cases, and the largest error of
// t. The sum of all is a case of a family of its own.
std::string table_by_family(const std::vector<Case>& cases);
// What all cases took, one line.
std::string as_text_of_sum(const Case& sum);

}  // namespace bench::stability
