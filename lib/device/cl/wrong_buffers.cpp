#include "device/cl/wrong_buffers.hpp"

#include "device/error.hpp"
#include "device/objects/host_read.hpp"
#include "device/objects/waiting.hpp"

namespace rsh {

void require_right_buffers(cl_uint bits) {
    if (!bits) return;
    const char* which = bits == RSH_WRONG_BOUNDS  ? "bounds: were"
                        : bits == RSH_WRONG_NODES ? "nodes: were"
                                                  : "bounds and nodes: were";
    throw Error(RSH_INVALID_VALUE, which,
                " not made for the call that got them, must come from rsh_bound and rsh_build "
                "with the same shape, triangles and rays");
}

cl_uint take_wrong_buffers(const Context& context, cl_command_queue queue) {
    const cl_mem word = context.wrong_buffers();
    Event before, cleared;
    require_success(clEnqueueBarrierWithWaitList(queue, 0, nullptr, before.out()),
                    "clEnqueueBarrierWithWaitList");
    const HostRead read(queue, word, 1, {1, before.list()});
    require_success(clFlush(queue), "clFlush");
    const cl_uint bits = *read.wait();
    if (!bits) return 0;
    const cl_uint none = 0;
    require_success(clEnqueueFillBuffer(queue, word, &none, sizeof none, 0, sizeof none, 0,
                                        nullptr, cleared.out()),
                    "clEnqueueFillBuffer");
    require_success(clFlush(queue), "clFlush");
    wait_for(cleared.get());
    return bits;
}

}  // namespace rsh
