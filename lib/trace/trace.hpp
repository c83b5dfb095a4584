// trace.hpp - what given rays hit, from triangles and rays to answers in one call; see rsh_trace.
#pragma once

#include <rsh/rsh.h>

#include "device/cl/recorder.hpp"
#include "device/layout.hpp"

namespace rsh {

// How the rays are traversed, but for buffers that lie in scratch.
rsh_traverse_desc trace_traverse(const rsh_trace_desc& desc);
// See reduce/strategy.hpp.
cl_uint chosen_strategy(const Context& context, const rsh_trace_desc& desc);
Layout trace_scratch(const Context& context, const rsh_trace_desc& desc);

void trace(Recorder& recorder, const rsh_trace_desc& desc);

}  // namespace rsh
