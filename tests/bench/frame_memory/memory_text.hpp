// memory_text.hpp - a case of rsh-bench memory as a line of text.
#pragma once

#include "results.hpp"

namespace bench::memory {

std::string as_text(const Case& c);

}  // namespace bench::memory
