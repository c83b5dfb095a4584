#include "device/objects/waiting.hpp"

namespace rsh {
namespace {

constexpr cl_int kFailed = CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST;

const char* name_or_nothing(cl_int status) {
    const char* const name = opencl_error_name(status);
    return name ? name : "";
}

cl_int checked_status_of(cl_event event) {
    return info<cl_int>(event, CL_EVENT_COMMAND_EXECUTION_STATUS);
}

}  // namespace

cl_int status_of(cl_event event) noexcept {
    cl_int status = CL_QUEUED;
    opencl(event).clGetEventInfo(event, CL_EVENT_COMMAND_EXECUTION_STATUS, sizeof status,
                                 &status, nullptr);
    return status;
}

void require_none_failed(cl_uint count, const cl_event* wait_list) {
    for (cl_uint i = 0; i < count; ++i) {
        const cl_int status = checked_status_of(wait_list[i]);
        if (status < CL_COMPLETE)
            throw Error(kFailed, "wait_list[", i, "]: failed with ", status, " ",
                        name_or_nothing(status), ", must not have failed");
    }
}

// What failed tells more than that waiting failed.
void wait_for_all(cl_uint count, const cl_event* wait_list) {
    const cl_int waited = opencl(*wait_list).clWaitForEvents(count, wait_list);
    require_none_failed(count, wait_list);
    require_success(waited, "clWaitForEvents");
}

void wait_for(cl_event event) {
    const cl_int waited = opencl(event).clWaitForEvents(1, &event),
                 status = checked_status_of(event);
    if (status < CL_COMPLETE)
        throw Error(kFailed, "a command failed with ", status, " ", name_or_nothing(status),
                    ": it, or what it waits for");
    require_success(waited, "clWaitForEvents");
}

}  // namespace rsh
