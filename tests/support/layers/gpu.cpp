// gpu.cpp - a layer in which every device says that it is a GPU, with the limits of one, and holds
// callers to them: work-groups, and where sub-buffers begin. Computes like the device below, whose
// compute units it has unless RSH_LAYER_UNITS says how many.
#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "support/layers/pass_on.hpp"

namespace {

using layer::below;

constexpr size_t kMostItems = 256;  // of a work-group
constexpr cl_ulong kLocalBytes = 48u << 10;
constexpr cl_uint kAlignmentBits = 4096;

template <class Number>
void say(void* value, Number number) {
    std::memcpy(value, &number, sizeof number);
}

void lower(void* value, size_t most) {
    size_t own = 0;
    std::memcpy(&own, value, sizeof own);
    say(value, std::min(own, most));
}

void say_units(void* value) {
    const char* units = std::getenv("RSH_LAYER_UNITS");
    if (units) say(value, static_cast<cl_uint>(std::strtoul(units, nullptr, 10)));
}

cl_int CL_API_CALL device_info(cl_device_id device, cl_device_info what, size_t size,
                               void* value, size_t* needed) {
    const cl_int status = below.clGetDeviceInfo(device, what, size, value, needed);
    if (status != CL_SUCCESS || !value) return status;
    switch (what) {
        case CL_DEVICE_TYPE:
            say(value, cl_device_type{CL_DEVICE_TYPE_GPU});
            break;
        case CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT:
        case CL_DEVICE_NATIVE_VECTOR_WIDTH_INT:
        case CL_DEVICE_PREFERRED_VECTOR_WIDTH_FLOAT:
        case CL_DEVICE_PREFERRED_VECTOR_WIDTH_INT:
            say(value, cl_uint{1});
            break;
        case CL_DEVICE_MAX_COMPUTE_UNITS:
            say_units(value);
            break;
        case CL_DEVICE_MAX_WORK_GROUP_SIZE:
            lower(value, kMostItems);
            break;
        case CL_DEVICE_LOCAL_MEM_SIZE:
            say(value, kLocalBytes);
            break;
        case CL_DEVICE_LOCAL_MEM_TYPE:
            say(value, cl_device_local_mem_type{CL_LOCAL});
            break;
        case CL_DEVICE_HOST_UNIFIED_MEMORY:
            say(value, cl_bool{CL_FALSE});
            break;
        case CL_DEVICE_MEM_BASE_ADDR_ALIGN:
            say(value, kAlignmentBits);
            break;
        default:
            break;
    }
    return status;
}

// What there is below when devices of a type are asked for: all of them, or none.
cl_device_type type_below(cl_device_type type) {
    const bool is_gpu = (type & (CL_DEVICE_TYPE_GPU | CL_DEVICE_TYPE_DEFAULT)) != 0;
    return is_gpu ? CL_DEVICE_TYPE_ALL : CL_DEVICE_TYPE_CUSTOM;
}

cl_int CL_API_CALL device_ids(cl_platform_id platform, cl_device_type type, cl_uint room,
                              cl_device_id* devices, cl_uint* count) {
    return below.clGetDeviceIDs(platform, type_below(type), room, devices, count);
}

cl_context CL_API_CALL context_from_type(const cl_context_properties* properties,
                                         cl_device_type type,
                                         void(CL_CALLBACK* notify)(const char*, const void*,
                                                                   size_t, void*),
                                         void* user, cl_int* status) {
    return below.clCreateContextFromType(properties, type_below(type), notify, user, status);
}

cl_int CL_API_CALL work_group_info(cl_kernel kernel, cl_device_id device,
                                   cl_kernel_work_group_info what, size_t size, void* value,
                                   size_t* needed) {
    const cl_int status =
        below.clGetKernelWorkGroupInfo(kernel, device, what, size, value, needed);
    if (status == CL_SUCCESS && value && what == CL_KERNEL_WORK_GROUP_SIZE)
        lower(value, kMostItems);
    return status;
}

cl_int CL_API_CALL enqueue_kernel(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions,
                                  const size_t* offset, const size_t* items,
                                  const size_t* group, cl_uint wait_count,
                                  const cl_event* waits, cl_event* event) {
    size_t group_items = 1;
    for (cl_uint d = 0; group && d < dimensions; ++d) group_items *= group[d];
    if (group_items > kMostItems) return CL_INVALID_WORK_GROUP_SIZE;
    return below.clEnqueueNDRangeKernel(queue, kernel, dimensions, offset, items, group,
                                        wait_count, waits, event);
}

cl_mem CL_API_CALL sub_buffer(cl_mem buffer, cl_mem_flags flags, cl_buffer_create_type type,
                              const void* what, cl_int* status) {
    if (type == CL_BUFFER_CREATE_TYPE_REGION && what &&
        static_cast<const cl_buffer_region*>(what)->origin % (kAlignmentBits / 8) != 0) {
        if (status) *status = CL_MISALIGNED_SUB_BUFFER_OFFSET;
        return nullptr;
    }
    return below.clCreateSubBuffer(buffer, flags, type, what, status);
}

}  // namespace

void layer::change(cl_icd_dispatch& calls) {
    calls.clGetDeviceInfo = device_info;
    calls.clGetDeviceIDs = device_ids;
    calls.clCreateContextFromType = context_from_type;
    calls.clGetKernelWorkGroupInfo = work_group_info;
    calls.clEnqueueNDRangeKernel = enqueue_kernel;
    calls.clCreateSubBuffer = sub_buffer;
}
