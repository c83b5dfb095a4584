// strips.hpp - into how many strips of rows a frame is cut, and its scene into batches of triangles, so that
// its memory keeps to the budget.
#pragma once

#include "device/cl/context.hpp"
#include "device/layout.hpp"

namespace rsh {

struct StripSize {
    cl_uint rows;       // of a strip; the last one may have less
    cl_uint triangles;  // of a batch, at most; 0: the scene does not come in batches
};

// The largest that fits. Throws where not even the least fits into what the caller allows.
StripSize strip_size(const Context& context, const rsh_frame_desc& desc);

}  // namespace rsh
