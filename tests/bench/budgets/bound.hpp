// bound.hpp - the error bounds that the kernels' proofs derive: what of, where, and how large.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bench::budgets {

struct Bound {
    const char* name;   // search_NAME in kernels/FILE.cl measures it
    const char* file;   // of kernels/
    uint32_t inputs;    // floats that it depends on
    const char* where;  // whose derivation it is
    const char* unit;   // of the figures: u = 2^-24, of what
    double derived;     // where quotients and roots are rounded correctly
    double rough;       // where they are two ulp off; 0: there are none
    double granted;     // what the code has room for
};

const std::vector<Bound>& all_bounds();

// The library's programs that a file of kernels/ is put behind.
std::vector<const char*> stems_of(const std::string& file);

// A piece of those, and what stands in its place.
struct Change {
    const char* from;
    const char* to;
    bool is_always =
        false;  // a search needs it; else only where quotients and roots are to be off
};
std::vector<Change> changes_of(const std::string& file);

}  // namespace bench::budgets
