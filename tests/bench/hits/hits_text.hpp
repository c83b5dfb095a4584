// hits_text.hpp - a case of rsh-bench hits as text.
#pragma once

#include <string>

#include "results.hpp"

namespace bench::hits {

// One line.
std::string as_text(const Case& c);

}  // namespace bench::hits
