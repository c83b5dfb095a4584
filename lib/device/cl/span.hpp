// span.hpp - where memory lies: a buffer, or a sub-buffer in its parent.
#pragma once

#include "device/error.hpp"
#include "device/objects/handle.hpp"

namespace rsh {

struct Span {
    cl_mem root;    // sub-buffers cannot be cut from sub-buffers, only from this
    size_t offset;  // in it
};

inline Span span_of(cl_mem memory) {
    if (!memory) return {nullptr, 0};
    const cl_mem parent = info<cl_mem>(memory, CL_MEM_ASSOCIATED_MEMOBJECT);
    if (!parent) return {memory, 0};
    return {parent, info<size_t>(memory, CL_MEM_OFFSET)};
}

// A part of it, as a buffer of its own; none of none.
inline Buffer part_of(const Span& span, size_t offset, size_t bytes) {
    if (!span.root) return {};
    const cl_buffer_region region = {span.offset + offset, bytes};
    cl_int status = CL_SUCCESS;
    Buffer part(opencl(span.root).clCreateSubBuffer(
        span.root, CL_MEM_READ_WRITE, CL_BUFFER_CREATE_TYPE_REGION, &region, &status));
    require_success(status, "clCreateSubBuffer");
    return part;
}

}  // namespace rsh
