// pipeline.hpp - the data flow of a frame; see pipeline.cpp.
#pragma once

#include "bounds/bound.hpp"
#include "cl/recorder.hpp"

namespace rsh {

const Bound& frame_bound(const rsh_frame_desc& desc);
Layout frame_scratch(const Context& context, const rsh_frame_desc& desc);
void frame(Recorder& recorder, const rsh_frame_desc& desc);

}  // namespace rsh
