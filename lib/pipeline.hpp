// pipeline.hpp - the data flow of a frame; see pipeline.cpp.
#pragma once

#include "device/cl/recorder.hpp"
#include "rays/bound.hpp"

namespace rsh {

const Bound& frame_bound(const rsh_frame_desc& desc);
Layout frame_scratch(const Context& context, const rsh_frame_desc& desc);
void frame(Recorder& recorder, const rsh_frame_desc& desc);

}  // namespace rsh
