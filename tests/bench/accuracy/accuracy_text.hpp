// accuracy_text.hpp - a case of rsh-bench accuracy as text.
#pragma once

#include <string>

#include "results.hpp"

namespace bench::accuracy {

// One line.
std::string as_text(const Case& c);

}  // namespace bench::accuracy
