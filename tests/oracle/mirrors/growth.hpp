// growth.hpp - how an error that is too small to part a path grows along it: what no tracer can
// help.
#pragma once

#include "oracle/mirrors/path.hpp"

namespace oracle {

// At each bounce, how many times the error is as large that rounding the first state of the path to
// floats makes, when all else is exact; to first order. The error's size is the root of the squares
// of that of the origin and that of the direction; `unit`: a length that counts as much as a
// radian.
std::vector<double> growth_along(const Path& exact, const Mirrors& mirrors, double unit);

}  // namespace oracle
