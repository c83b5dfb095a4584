// bound.hpp - bounds of the triangles, of any shape.
#pragma once

#include "device/cl/recorder.hpp"

namespace rsh {

void bound(Recorder& recorder, const rsh_bound_desc& desc);

}  // namespace rsh
