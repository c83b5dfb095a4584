// search.hpp - looks for the input on which a bound's error is the largest.
#pragma once

#include <cstdint>
#include <vector>

#include "device.hpp"

namespace bench::budgets {

// What work-items go on from: the worst input of each, `width` floats, and its error; -1: none.
struct Population {
    std::vector<float> worst, inputs;
    size_t width;

    Population(size_t items, size_t floats)
        : worst(items, -1.0f), inputs(items * floats), width(floats) {}

    size_t items() const { return worst.size(); }
    size_t largest() const;  // index of the largest error
    // Of the better half nothing changes; of the others, half go on from the best eighth, half
    // begin anew.
    void breed();
};

struct Worst {
    uint64_t evaluations = 0;  // that the bound applied to
    float error = -1.0f;
    std::vector<float> input;
};

// Until the bound applied to so many. kernel: see kernels/search.h. Throws std::runtime_error where
// it never applies.
Worst search(const Device& device, cl::Kernel& kernel, size_t width, uint64_t evaluations);

}  // namespace bench::budgets
