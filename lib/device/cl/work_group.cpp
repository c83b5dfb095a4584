#include "device/cl/work_group.hpp"

#include "device/error.hpp"

namespace rsh {

namespace {

template <class Value>
Value group_info(cl_kernel kernel, cl_device_id device, cl_kernel_work_group_info what) {
    Value value = {};
    require_success(opencl(kernel).clGetKernelWorkGroupInfo(kernel, device, what, sizeof value,
                                                            &value, nullptr),
                    "clGetKernelWorkGroupInfo");
    return value;
}

}  // namespace

GroupLimits group_limits(cl_kernel kernel, cl_device_id device) {
    return {group_info<size_t>(kernel, device, CL_KERNEL_WORK_GROUP_SIZE),
            group_info<cl_ulong>(kernel, device, CL_KERNEL_LOCAL_MEM_SIZE),
            info<cl_ulong>(device, CL_DEVICE_LOCAL_MEM_SIZE)};
}

size_t fitting_group(const char* kernel, const Range& range, const GroupLimits& limits) {
    if (limits.local_bytes > limits.local_memory)
        throw Error(RSH_UNSUPPORTED, kernel, ": needs ", limits.local_bytes,
                    " bytes of local memory, the device has ", limits.local_memory);
    if (range.group_size <= limits.items) return range.group_size;
    if (range.takes_smaller_groups && limits.items > 0) return limits.items;
    throw Error(RSH_UNSUPPORTED, kernel, ": needs work-groups of ", range.group_size,
                " work-items, the device runs at most ", limits.items, " of this kernel");
}

}  // namespace rsh
