// build.hpp - the hierarchy over the rays, of any bound.
#pragma once

#include "device/cl/recorder.hpp"

namespace rsh {

void build(Recorder& recorder, const rsh_build_desc& desc);

}  // namespace rsh
