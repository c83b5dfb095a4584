#include "api/check.hpp"

#include "device/objects/waiting.hpp"

namespace rsh {

void require_not_null(const void* pointer, const char* field) {
    if (!pointer) throw Error(RSH_INVALID_VALUE, field, ": is NULL, must not be");
}

Context& checked_context(rsh_context context) {
    require_not_null(context, "context");
    return *context;
}

void check_submission(const Context& context, cl_command_queue queue, cl_uint wait_count,
                      const cl_event* wait_list) {
    require_not_null(queue, "queue");
    if (info<cl_context>(queue, CL_QUEUE_CONTEXT) != context.cl.get() ||
        info<cl_device_id>(queue, CL_QUEUE_DEVICE) != context.device)
        throw Error(RSH_INVALID_VALUE,
                    "queue: is of another context or device, must be of the rsh_context's");
    require((wait_count == 0) == (wait_list == nullptr), "wait_count", wait_count,
            wait_list ? "above 0 with a wait_list" : "0 without a wait_list");
    for (cl_uint i = 0; i < wait_count; ++i) require_not_null(wait_list[i], "wait_list[i]");
    require_none_failed(wait_count, wait_list);
}

}  // namespace rsh
