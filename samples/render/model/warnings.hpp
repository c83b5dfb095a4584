// warnings.hpp - what was found on the way to a failure, which often explains it.
#pragma once

#include <string>
#include <vector>

namespace render {

// The message, and below it a line for each warning, or for the first of very many.
std::string with_warnings(const std::string& message, const std::vector<std::string>& warnings);

}  // namespace render
