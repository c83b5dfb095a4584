// opencl.cpp - the calls of OpenCL that rsh makes, so that one can be made to fail, and references to
// objects be counted. A call that fails does nothing, but that an object is released: it would be
// lost, whoever asked.
#define CL_TARGET_OPENCL_VERSION 120
#define CL_USE_DEPRECATED_OPENCL_1_2_APIS
#include <CL/cl.h>
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

#include "faults/faults.hpp"

namespace {

using faults::InsideOpenCl;
using faults::Kind;

template <class Function>
Function next(const char* name) {
    void* const found = dlsym(RTLD_NEXT, name);
    if (!found) {
        std::fprintf(stderr, "there is no %s\n", name);
        std::abort();
    }
    return reinterpret_cast<Function>(found);
}

bool fails(const InsideOpenCl& inside, const char* name) {
    return !inside.is_nested() && faults::fails_now(Kind::opencl, name);
}

template <class Object>
Object created(const InsideOpenCl& inside, Object object) {
    if (object && !inside.is_nested()) faults::count_reference(1);
    return object;
}

cl_int changed(const InsideOpenCl& inside, cl_int status, int change) {
    if (status == CL_SUCCESS && !inside.is_nested()) faults::count_reference(change);
    return status;
}

cl_int enqueued(const InsideOpenCl& inside, cl_int status, const cl_event* event) {
    if (status == CL_SUCCESS && event) created(inside, *event);
    return status;
}

}  // namespace

// NOLINTBEGIN(bugprone-macro-parentheses): lists of arguments have theirs.
// `after` sees `result`, and `event` where the call has one.
#define RSH_STATUS_CALL(name, parameters, arguments, after)      \
    cl_int CL_API_CALL name parameters {                         \
        const InsideOpenCl inside;                               \
        static const auto real = next<decltype(&name)>(#name);   \
        if (fails(inside, #name)) return faults::failing_code(); \
        const cl_int result = real arguments;                    \
        return after;                                            \
    }
#define RSH_INFO_CALL(name, type)                                                          \
    RSH_STATUS_CALL(name,                                                                  \
                    (type object, cl_uint what, size_t size, void* value, size_t* needed), \
                    (object, what, size, value, needed), result)
#define RSH_RETAIN_CALL(name, type) \
    RSH_STATUS_CALL(name, (type object), (object), changed(inside, result, 1))
#define RSH_RELEASE_CALL(name, type)                             \
    cl_int CL_API_CALL name(type object) {                       \
        const InsideOpenCl inside;                               \
        static const auto real = next<decltype(&name)>(#name);   \
        const bool is_failure = fails(inside, #name);            \
        const cl_int result = changed(inside, real(object), -1); \
        return is_failure ? faults::failing_code() : result;     \
    }
#define RSH_ENQUEUE_CALL(name, parameters, arguments) \
    RSH_STATUS_CALL(name, parameters, arguments, enqueued(inside, result, event))
#define RSH_CREATE_CALL(type, name, parameters, arguments)                 \
    type CL_API_CALL name parameters {                                     \
        const InsideOpenCl inside;                                         \
        static const auto real = next<decltype(&name)>(#name);             \
        if (!fails(inside, #name)) return created(inside, real arguments); \
        if (status) *status = faults::failing_code();                      \
        return nullptr;                                                    \
    }

// NOLINTEND(bugprone-macro-parentheses)

extern "C" {

RSH_STATUS_CALL(clGetPlatformIDs, (cl_uint room, cl_platform_id* ids, cl_uint* count),
                (room, ids, count), result)
RSH_STATUS_CALL(clGetDeviceIDs,
                (cl_platform_id platform, cl_device_type type, cl_uint room, cl_device_id* ids,
                 cl_uint* count),
                (platform, type, room, ids, count), result)

RSH_INFO_CALL(clGetPlatformInfo, cl_platform_id)
RSH_INFO_CALL(clGetDeviceInfo, cl_device_id)
RSH_INFO_CALL(clGetContextInfo, cl_context)
RSH_INFO_CALL(clGetCommandQueueInfo, cl_command_queue)
RSH_INFO_CALL(clGetMemObjectInfo, cl_mem)
RSH_INFO_CALL(clGetProgramInfo, cl_program)
RSH_INFO_CALL(clGetKernelInfo, cl_kernel)
RSH_INFO_CALL(clGetEventInfo, cl_event)
RSH_INFO_CALL(clGetEventProfilingInfo, cl_event)
RSH_STATUS_CALL(clGetKernelWorkGroupInfo,
                (cl_kernel kernel, cl_device_id device, cl_kernel_work_group_info what,
                 size_t size, void* value, size_t* needed),
                (kernel, device, what, size, value, needed), result)
RSH_STATUS_CALL(clGetProgramBuildInfo,
                (cl_program program, cl_device_id device, cl_program_build_info what,
                 size_t size, void* value, size_t* needed),
                (program, device, what, size, value, needed), result)

RSH_RETAIN_CALL(clRetainContext, cl_context)
RSH_RETAIN_CALL(clRetainCommandQueue, cl_command_queue)
RSH_RETAIN_CALL(clRetainMemObject, cl_mem)
RSH_RETAIN_CALL(clRetainProgram, cl_program)
RSH_RETAIN_CALL(clRetainKernel, cl_kernel)
RSH_RETAIN_CALL(clRetainEvent, cl_event)
RSH_RELEASE_CALL(clReleaseContext, cl_context)
RSH_RELEASE_CALL(clReleaseCommandQueue, cl_command_queue)
RSH_RELEASE_CALL(clReleaseMemObject, cl_mem)
RSH_RELEASE_CALL(clReleaseProgram, cl_program)
RSH_RELEASE_CALL(clReleaseKernel, cl_kernel)
RSH_RELEASE_CALL(clReleaseEvent, cl_event)

RSH_CREATE_CALL(cl_context, clCreateContext,
                (const cl_context_properties* properties, cl_uint count,
                 const cl_device_id* devices,
                 void(CL_CALLBACK* notify)(const char*, const void*, size_t, void*), void* user,
                 cl_int* status),
                (properties, count, devices, notify, user, status))
RSH_CREATE_CALL(cl_command_queue, clCreateCommandQueue,
                (cl_context context, cl_device_id device,
                 cl_command_queue_properties properties, cl_int* status),
                (context, device, properties, status))
RSH_CREATE_CALL(cl_mem, clCreateBuffer,
                (cl_context context, cl_mem_flags flags, size_t size, void* data,
                 cl_int* status),
                (context, flags, size, data, status))
RSH_CREATE_CALL(cl_mem, clCreateSubBuffer,
                (cl_mem buffer, cl_mem_flags flags, cl_buffer_create_type type,
                 const void* region, cl_int* status),
                (buffer, flags, type, region, status))
RSH_CREATE_CALL(cl_program, clCreateProgramWithSource,
                (cl_context context, cl_uint count, const char** strings, const size_t* lengths,
                 cl_int* status),
                (context, count, strings, lengths, status))
RSH_CREATE_CALL(cl_program, clCreateProgramWithBinary,
                (cl_context context, cl_uint count, const cl_device_id* devices,
                 const size_t* lengths, const unsigned char** binaries, cl_int* statuses,
                 cl_int* status),
                (context, count, devices, lengths, binaries, statuses, status))
RSH_CREATE_CALL(cl_kernel, clCreateKernel,
                (cl_program program, const char* name, cl_int* status), (program, name, status))
RSH_CREATE_CALL(cl_event, clCreateUserEvent, (cl_context context, cl_int* status),
                (context, status))

RSH_STATUS_CALL(clBuildProgram,
                (cl_program program, cl_uint count, const cl_device_id* devices,
                 const char* options, void(CL_CALLBACK* notify)(cl_program, void*), void* user),
                (program, count, devices, options, notify, user), result)
RSH_STATUS_CALL(clSetKernelArg,
                (cl_kernel kernel, cl_uint index, size_t size, const void* value),
                (kernel, index, size, value), result)
RSH_STATUS_CALL(clFlush, (cl_command_queue queue), (queue), result)
RSH_STATUS_CALL(clFinish, (cl_command_queue queue), (queue), result)
RSH_STATUS_CALL(clWaitForEvents, (cl_uint count, const cl_event* events), (count, events),
                result)
RSH_STATUS_CALL(clSetEventCallback,
                (cl_event event, cl_int type,
                 void(CL_CALLBACK* notify)(cl_event, cl_int, void*), void* user),
                (event, type, notify, user), result)

RSH_ENQUEUE_CALL(clEnqueueNDRangeKernel,
                 (cl_command_queue queue, cl_kernel kernel, cl_uint dimensions,
                  const size_t* offset, const size_t* global, const size_t* local,
                  cl_uint count, const cl_event* waits, cl_event* event),
                 (queue, kernel, dimensions, offset, global, local, count, waits, event))
RSH_ENQUEUE_CALL(clEnqueueReadBuffer,
                 (cl_command_queue queue, cl_mem buffer, cl_bool blocking, size_t offset,
                  size_t size, void* data, cl_uint count, const cl_event* waits,
                  cl_event* event),
                 (queue, buffer, blocking, offset, size, data, count, waits, event))
RSH_ENQUEUE_CALL(clEnqueueWriteBuffer,
                 (cl_command_queue queue, cl_mem buffer, cl_bool blocking, size_t offset,
                  size_t size, const void* data, cl_uint count, const cl_event* waits,
                  cl_event* event),
                 (queue, buffer, blocking, offset, size, data, count, waits, event))
RSH_ENQUEUE_CALL(clEnqueueCopyBuffer,
                 (cl_command_queue queue, cl_mem from, cl_mem to, size_t from_offset,
                  size_t to_offset, size_t size, cl_uint count, const cl_event* waits,
                  cl_event* event),
                 (queue, from, to, from_offset, to_offset, size, count, waits, event))
RSH_ENQUEUE_CALL(clEnqueueFillBuffer,
                 (cl_command_queue queue, cl_mem buffer, const void* pattern,
                  size_t pattern_size, size_t offset, size_t size, cl_uint count,
                  const cl_event* waits, cl_event* event),
                 (queue, buffer, pattern, pattern_size, offset, size, count, waits, event))
RSH_ENQUEUE_CALL(clEnqueueMarkerWithWaitList,
                 (cl_command_queue queue, cl_uint count, const cl_event* waits,
                  cl_event* event),
                 (queue, count, waits, event))
RSH_ENQUEUE_CALL(clEnqueueBarrierWithWaitList,
                 (cl_command_queue queue, cl_uint count, const cl_event* waits,
                  cl_event* event),
                 (queue, count, waits, event))

}  // extern "C"
