// ablation_text.hpp - a case as a line.
#pragma once

#include <string>

#include "results.hpp"

namespace bench::ablation {

std::string as_text(const Case& c);

}  // namespace bench::ablation
