#include "device/error.hpp"

#include <new>

#ifndef CL_TARGET_OPENCL_VERSION
#define CL_TARGET_OPENCL_VERSION 120
#endif
#include <CL/cl.h>

namespace rsh {
namespace {

constexpr size_t kMessageBytes = 16384;
thread_local char message_of_thread[kMessageBytes] = "";

struct Code {
    cl_int code;
    const char* name;
};

#define RSH_CODE(name) \
    { name, #name }
constexpr Code kCodes[] = {
    RSH_CODE(CL_DEVICE_NOT_FOUND),
    RSH_CODE(CL_DEVICE_NOT_AVAILABLE),
    RSH_CODE(CL_COMPILER_NOT_AVAILABLE),
    RSH_CODE(CL_MEM_OBJECT_ALLOCATION_FAILURE),
    RSH_CODE(CL_OUT_OF_RESOURCES),
    RSH_CODE(CL_OUT_OF_HOST_MEMORY),
    RSH_CODE(CL_PROFILING_INFO_NOT_AVAILABLE),
    RSH_CODE(CL_MEM_COPY_OVERLAP),
    RSH_CODE(CL_BUILD_PROGRAM_FAILURE),
    RSH_CODE(CL_MAP_FAILURE),
    RSH_CODE(CL_MISALIGNED_SUB_BUFFER_OFFSET),
    RSH_CODE(CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST),
    RSH_CODE(CL_INVALID_VALUE),
    RSH_CODE(CL_INVALID_DEVICE_TYPE),
    RSH_CODE(CL_INVALID_PLATFORM),
    RSH_CODE(CL_INVALID_DEVICE),
    RSH_CODE(CL_INVALID_CONTEXT),
    RSH_CODE(CL_INVALID_QUEUE_PROPERTIES),
    RSH_CODE(CL_INVALID_COMMAND_QUEUE),
    RSH_CODE(CL_INVALID_HOST_PTR),
    RSH_CODE(CL_INVALID_MEM_OBJECT),
    RSH_CODE(CL_INVALID_BINARY),
    RSH_CODE(CL_INVALID_BUILD_OPTIONS),
    RSH_CODE(CL_INVALID_PROGRAM),
    RSH_CODE(CL_INVALID_PROGRAM_EXECUTABLE),
    RSH_CODE(CL_INVALID_KERNEL_NAME),
    RSH_CODE(CL_INVALID_KERNEL),
    RSH_CODE(CL_INVALID_ARG_INDEX),
    RSH_CODE(CL_INVALID_ARG_VALUE),
    RSH_CODE(CL_INVALID_ARG_SIZE),
    RSH_CODE(CL_INVALID_KERNEL_ARGS),
    RSH_CODE(CL_INVALID_WORK_DIMENSION),
    RSH_CODE(CL_INVALID_WORK_GROUP_SIZE),
    RSH_CODE(CL_INVALID_WORK_ITEM_SIZE),
    RSH_CODE(CL_INVALID_GLOBAL_OFFSET),
    RSH_CODE(CL_INVALID_EVENT_WAIT_LIST),
    RSH_CODE(CL_INVALID_EVENT),
    RSH_CODE(CL_INVALID_OPERATION),
    RSH_CODE(CL_INVALID_BUFFER_SIZE),
    RSH_CODE(CL_INVALID_GLOBAL_WORK_SIZE),
    {-1001, "CL_PLATFORM_NOT_FOUND_KHR"},
};
#undef RSH_CODE

rsh_status fail(rsh_status status, const char* message) noexcept {
    return Error(status, message).status();
}

}  // namespace

const char* last_error() noexcept {
    return message_of_thread;
}

void clear_last_error() noexcept {
    message_of_thread[0] = '\0';
}

Text new_error_text() noexcept {
    return {message_of_thread, kMessageBytes};
}

const char* opencl_error_name(cl_int code) noexcept {
    for (const Code& known : kCodes)
        if (known.code == code) return known.name;
    return nullptr;
}

Error opencl_error(cl_int code, const char* call) noexcept {
    const char* const name = opencl_error_name(code);
    return name ? Error(code, call, " failed: ", name) : Error(code, call, " failed: ", code);
}

rsh_status guarded_call(void (*body)(void*), void* argument) noexcept {
    clear_last_error();
    try {
        body(argument);
        clear_last_error();  // of what failed and did not matter
        return RSH_SUCCESS;
    } catch (const Error& error) {
        return error.status();
    } catch (const std::bad_alloc&) {
        return fail(RSH_OUT_OF_MEMORY, "the host is out of memory");
    } catch (const std::exception& error) {
        return fail(RSH_INTERNAL_ERROR, error.what());
    } catch (...) {
        return fail(RSH_INTERNAL_ERROR, "an exception of unknown type");
    }
}

}  // namespace rsh
