// rasterize.hpp - primary rays and their closest hits, in screen tiles (camera/rasterize.cl).
#pragma once

#include "device/cl/recorder.hpp"

namespace rsh {

Layout rasterize_scratch(const Context& context, const rsh_rasterize_desc& desc);

void rasterize(Recorder& recorder, const rsh_rasterize_desc& desc);

}  // namespace rsh
