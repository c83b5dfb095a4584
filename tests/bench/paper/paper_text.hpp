// paper_text.hpp - a case of rsh-bench paper as text.
#pragma once

#include <string>

#include "results.hpp"

namespace bench::paper {

// A few lines, with the bars that it has, see bars.hpp, and whether they hold.
std::string as_text(const Case& c);

}  // namespace bench::paper
