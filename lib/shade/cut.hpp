// cut.hpp - what a wave's rays see by branches that are not traced (kernels/shade/cut.cl).
#pragma once

#include <rsh/rsh.h>

#include "device/cl/recorder.hpp"

namespace rsh {

// Branches that weigh no more than min_weight are not traced; infinite: none is. The scene's cut is
// not black.
void add_cut(Recorder& recorder, const rsh_shade_desc& wave, float min_weight);

}  // namespace rsh
