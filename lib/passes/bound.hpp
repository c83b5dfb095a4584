// bound.hpp - spheres around the triangles (bound.cl).
#pragma once

#include "cl/recorder.hpp"

namespace rsh {

void bound(Recorder& recorder, const rsh_bound_desc& desc);

}  // namespace rsh
