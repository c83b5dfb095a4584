// find_surfaces.hpp - what rays hit, one record each (kernels/shade/find_surfaces.cl).
#pragma once

#include <rsh/rsh.h>

#include "device/cl/recorder.hpp"

namespace rsh {

void find_surfaces(Recorder& recorder, const rsh_find_surfaces_desc& desc);

}  // namespace rsh
