// answers.hpp - what each operation of arithmetic/probe.cl must give: worked out in double, which
// holds sums, products, quotients and roots of floats so well that rounding them once more to float
// is rounding once (Figueroa, "When is double rounding innocuous?", SIGNUM Newsletter 30(3), 1995).
#pragma once

#include <rsh/rsh.h>

#include "arithmetic/types.h"

namespace rsh {

// Values of floats.
struct Operands {
    double a, b, c, d;
};

struct Operation {
    probe_row row;
    cl_uint property;  // RSH_ARITHMETIC_..., that of ordinary operands
    const char* text;
    bool is_integer;  // the result's bits are those of an int
    // Rounded to float, the right result.
    double (*answer)(const Operands&);
};

using Operations = const Operation (&)[RSH_PROBE_ROWS];
Operations operations();

// With denormals as zeros.
Operands flushed(const Operands& operands);

// In units in the last place: how far a result may be off that need not be rounded correctly.
constexpr double kQuotientUlps = 2.5, kRootUlps = 3;

// Whether a result is the right one: rounded to nearest, or at most `ulps` off, if that is not 0. A
// result below the smallest normal float may be 0; signs of zeros and bits of NaN do not matter.
bool is_right(float found, double answer, double ulps);

}  // namespace rsh
