// budgets_of.hpp - which budgets a call is measured with, and whether it keeps to them. Knows no device.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace bench::memory {

struct Budget {
    std::string name;  // "least", "2x", "4x", "whole", "none"
    size_t bytes;      // 0: none is set
};

// The least, and `factor`, `factor` squared, ... times that, up to what the call takes without a
// budget, the last one.
std::vector<Budget> budgets_from(size_t least, size_t whole, size_t factor);

// What a refusal says that a budget must be: "budget: is 1, must be 0 or at least 4096". Throws
// std::runtime_error where it does not.
size_t least_named_by(const std::string& refusal);

// Whether a budget one byte below the least is refused as it must be.
bool is_refusal_below(const std::string& refusal, size_t least);

// Of bytes that existed at once. A call that allocates nothing was not seen.
bool keeps_to(size_t allowed, size_t peak);

}  // namespace bench::memory
