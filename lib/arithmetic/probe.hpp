// probe.hpp - the second half of rsh_device_selftest: whether the device does arithmetic as the
// proofs in kernels/ assume. What does not hold is reported, and left to the caller.
#pragma once

#include "device/cl/context.hpp"

namespace rsh {

// NULL: there is no such property.
const char* arithmetic_name(cl_uint property);

// BLOCKS. Adds to *report what is about arithmetic.
void probe_arithmetic(Context& context, cl_command_queue queue, rsh_selftest& report);

}  // namespace rsh
