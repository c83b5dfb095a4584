#include "device/cl/wrong_buffers.hpp"

#include "device/error.hpp"

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
    const cl::CommandQueue commands(queue, true);
    const cl::Buffer word(context.wrong_buffers(), true);
    cl::Event before;
    commands.enqueueBarrierWithWaitList(nullptr, &before);
    const std::vector<cl::Event> wait = {before};
    cl_uint bits = 0;
    commands.enqueueReadBuffer(word, CL_TRUE, 0, sizeof bits, &bits, &wait);
    const cl_uint none = 0;
    if (bits) commands.enqueueWriteBuffer(word, CL_TRUE, 0, sizeof none, &none);
    return bits;
}

}  // namespace rsh
