// count_calls.hpp - the calls of a layer that only pass on and count: see counts.cpp.
#pragma once

#include "support/layers/pass_on.hpp"

namespace layer {

// Launches, fills, copies, waits, and the making, holding and releasing of all objects but buffers
// and programs of binaries.
void count_calls(cl_icd_dispatch& calls);

}  // namespace layer
