// shadow.hpp - which lights are hidden where a wave of rays hits; see rsh_shadow.
#pragma once

#include <rsh/rsh.h>

#include "device/cl/recorder.hpp"
#include "device/layout.hpp"

namespace rsh {

// How the shadow rays of a light are traversed, but for its number and for buffers that lie in
// scratch.
rsh_traverse_desc shadow_traverse(const rsh_shadow_desc& desc);
// The strategy of all its traversals; see reduce/strategy.hpp.
cl_uint chosen_strategy(const Context& context, const rsh_shadow_desc& desc);
Layout shadow_scratch(const Context& context, const rsh_shadow_desc& desc);

void shadow(Recorder& recorder, const rsh_shadow_desc& desc);

}  // namespace rsh
