// totals.hpp - what was run of a family, or of all: each ray and each decision once, however many
// cases share it.
#pragma once

#include <cstdint>

namespace bench::stability {

struct Totals {
    uint64_t rays = 0;
    uint64_t pairs = 0;      // of a ray and a triangle, by all engines
    uint64_t decisions = 0;  // of the oracles
    uint64_t undecided = 0;  // of these

    void add(const Totals& other) {
        rays += other.rays;
        pairs += other.pairs;
        decisions += other.decisions;
        undecided += other.undecided;
    }
};

}  // namespace bench::stability
