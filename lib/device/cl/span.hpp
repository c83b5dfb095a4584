// span.hpp - where memory lies: a buffer, or a sub-buffer in its parent.
#pragma once

#include "device/objects/handle.hpp"

namespace rsh {

struct Span {
    cl_mem root;    // sub-buffers cannot be cut from sub-buffers, only from this
    size_t offset;  // in it
};

inline Span span_of(cl_mem memory) {
    const cl_mem parent = info<cl_mem>(memory, CL_MEM_ASSOCIATED_MEMOBJECT);
    if (!parent) return {memory, 0};
    return {parent, info<size_t>(memory, CL_MEM_OFFSET)};
}

}  // namespace rsh
