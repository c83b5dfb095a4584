// measured_program.hpp - the library's kernels with a search behind them, as one program.
#pragma once

#include <string>

#include "device.hpp"

namespace bench::budgets {

// file: of kernels/. is_rough: quotients and roots two ulp off. Throws where a piece of the library
// that is to be changed is not there, or where the program does not compile, with the log.
cl::Program measured_program(const Device& device, const std::string& file, bool is_rough);

// Replaces each place; throws std::runtime_error, naming `from`, where there is none.
std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace bench::budgets
