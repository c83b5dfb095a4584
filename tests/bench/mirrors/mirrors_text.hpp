// mirrors_text.hpp - cases of rsh-bench mirrors as text.
#pragma once

#include <string>
#include <vector>

#include "results.hpp"

namespace bench::mirrors {

// Of one kind of normals: some bounces, with the median errors of each line and the paths that it
// has lost.
std::string table_of(const std::vector<Case>& cases);

}  // namespace bench::mirrors
