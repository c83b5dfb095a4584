// wrong_buffers.hpp - what traversals met that was not made for them: a word per context that
// kernels add RSH_WRONG_... bits to; see "Opaque" in rsh.h.
#pragma once

#include "device/cl/context.hpp"

namespace rsh {

// Throws RSH_INVALID_VALUE with a text that says which, unless `bits` are 0.
void require_right_buffers(cl_uint bits);

// BLOCKS for what `queue` holds; then the word is 0 again.
cl_uint take_wrong_buffers(Context& context, cl_command_queue queue);

}  // namespace rsh
