#include "device/objects/handle.hpp"

namespace rsh {

// OpenCL takes no pointer to constants, and only reads what is copied.
Buffer new_buffer(cl_context context, cl_mem_flags flags, size_t bytes, const void* contents) {
    cl_int status = CL_SUCCESS;
    Buffer buffer(opencl(context).clCreateBuffer(context,
                                                 flags | (contents ? CL_MEM_COPY_HOST_PTR : 0),
                                                 bytes, const_cast<void*>(contents), &status));
    require_success(status, "clCreateBuffer");
    return buffer;
}

}  // namespace rsh
