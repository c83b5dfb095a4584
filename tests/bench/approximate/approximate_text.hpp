// approximate_text.hpp - a case of rsh-bench approximate as text.
#pragma once

#include <string>

#include "results.hpp"

namespace bench::approximate {

// One line.
std::string as_text(const Case& c);

}  // namespace bench::approximate
