// shade.hpp - what the hits of a wave of rays add to the colours of its rays.
#pragma once

#include <rsh/rsh.h>

#include "device/cl/recorder.hpp"

namespace rsh {

void shade(Recorder& recorder, const rsh_shade_desc& desc);
// Of colours that nothing was added to before, nor set.
void shade_first(Recorder& recorder, const rsh_shade_desc& desc);

}  // namespace rsh
