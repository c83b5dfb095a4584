// pipeline.hpp - the data flow of a frame; see pipeline.cpp.
#pragma once

#include "device/cl/recorder.hpp"

namespace rsh {

void frame(Recorder& recorder, const rsh_frame_desc& desc);

}  // namespace rsh
