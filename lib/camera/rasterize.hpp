// rasterize.hpp - primary rays and their closest hits, in screen tiles (camera/rasterize.cl).
#pragma once

#include "device/cl/recorder.hpp"

namespace rsh {

// Of a picture that a window may lie in, see rsh_window.
inline cl_uint picture_side(cl_uint pictures, cl_uint calls) {
    return pictures ? pictures : calls;
}

Layout rasterize_scratch(const Context& context, const rsh_rasterize_desc& desc);

void rasterize(Recorder& recorder, const rsh_rasterize_desc& desc);

}  // namespace rsh
