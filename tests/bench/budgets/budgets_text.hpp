// budgets_text.hpp - what rsh-bench budgets prints.
#pragma once

#include <string>
#include <vector>

#include "results.hpp"

namespace bench::budgets {

// A line of a finished case.
std::string as_text(const Case& c);

// A row per bound; empty without cases.
std::string table_of_budgets(const std::vector<Case>& cases);

}  // namespace bench::budgets
