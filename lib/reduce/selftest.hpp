// selftest.hpp - rsh_device_selftest: runs every strategy on streams that drivers are known to
// get wrong, and masks those that fail on the context.
#pragma once

#include "reduce/strategy.hpp"

namespace rsh {

// BLOCKS. Adds to *report, which is zero, what is about strategies.
void selftest(Context& context, cl_command_queue queue, rsh_selftest& report);

}  // namespace rsh
