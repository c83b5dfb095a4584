// cases.hpp - the operands that arithmetic is probed with: many at random, and those that are hard.
// What they must give is in answers.hpp.
#pragma once

#include <vector>

#include "arithmetic/answers.hpp"

namespace rsh {

struct Cases {
    std::vector<Operands> operands;
    bool is_tiny;        // denormals, and what comes near them
    cl_uint probe_rows;  // bit r: row r is compared
};

// Ordinary sizes; then zeros, infinities, NaN and what overflows, each with each; then the tiny.
std::vector<Cases> arithmetic_cases();

}  // namespace rsh
