// strips.hpp - into how many strips of rows a frame is cut, so that its memory keeps to the budget.
#pragma once

#include "device/cl/context.hpp"
#include "device/layout.hpp"

namespace rsh {

// Rows of a strip, but for the last one, which may have less. Throws where not even a strip of the
// least height fits into what the caller allows.
cl_uint strip_rows(const Context& context, const rsh_frame_desc& desc);

}  // namespace rsh
