// work_group.hpp - how many work-items of a kernel go together. A kernel may bear fewer than its
// device, for want of registers or of local memory, which only the compiled kernel knows.
#pragma once

#include <cstddef>

#include "device/objects/handle.hpp"

namespace rsh {

struct Range {
    size_t items;  // rounded up to whole groups
    size_t group_size;
    bool takes_smaller_groups = false;  // nothing else depends on group_size
};

struct GroupLimits {
    size_t items;           // CL_KERNEL_WORK_GROUP_SIZE
    cl_ulong local_bytes;   // CL_KERNEL_LOCAL_MEM_SIZE, arguments included
    cl_ulong local_memory;  // of the device, bytes
};

// Of a kernel with arguments.
GroupLimits group_limits(cl_kernel kernel, cl_device_id device);

// The range's, or the largest that the kernel bears. Throws where neither is possible.
size_t fitting_group(const char* kernel, const Range& range, const GroupLimits& limits);

}  // namespace rsh
