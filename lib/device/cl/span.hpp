// span.hpp - where memory lies: a buffer, or a sub-buffer in its parent.
#pragma once

#include "device/cl/opencl.hpp"

namespace rsh {

struct Span {
    cl::Buffer root;  // sub-buffers cannot be cut from sub-buffers, only from this
    size_t offset;    // in it
};

inline Span span_of(cl_mem memory) {
    const cl::Buffer buffer(memory, true);
    const cl::Memory parent = buffer.getInfo<CL_MEM_ASSOCIATED_MEMOBJECT>();
    if (!parent()) return {buffer, 0};
    return {cl::Buffer(parent(), true), buffer.getInfo<CL_MEM_OFFSET>()};
}

}  // namespace rsh
