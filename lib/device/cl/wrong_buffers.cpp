#include "device/cl/wrong_buffers.hpp"

#include "device/error.hpp"
#include "device/objects/host_read.hpp"
#include "device/objects/waiting.hpp"

namespace rsh {

namespace {

// The commands of a call, held on as others'.
class KeptCommands {
public:
    explicit KeptCommands(UnderWay& under_way) : under_way_(under_way), call_(1) {
        call_.front().commands.reserve(3);
    }
    ~KeptCommands() {
        std::vector<Event>& made = call_.front().commands;
        if (!made.empty() && !made.back()) made.pop_back();
        under_way_.keep(std::move(call_));
    }
    KeptCommands(const KeptCommands&) = delete;
    KeptCommands& operator=(const KeptCommands&) = delete;

    // Where the next one's event goes.
    cl_event* next() { return call_.front().commands.emplace_back().out(); }
    Waits after_last() const { return {1, call_.front().commands.back().list()}; }

private:
    UnderWay& under_way_;
    UnderWay::Calls call_;
};

}  // namespace

void require_right_buffers(cl_uint bits) {
    if (!bits) return;
    const char* which = bits == RSH_WRONG_BOUNDS  ? "bounds: were"
                        : bits == RSH_WRONG_NODES ? "nodes: were"
                                                  : "bounds and nodes: were";
    throw Error(RSH_INVALID_VALUE, which,
                " not made for the call that got them, must come from rsh_bound and rsh_build "
                "with the same shape, triangles and rays");
}

cl_uint take_wrong_buffers(Context& context, cl_command_queue queue) {
    const cl_mem word = context.wrong_buffers();
    KeptCommands kept(context.under_way);
    require_success(opencl(queue).clEnqueueBarrierWithWaitList(queue, 0, nullptr, kept.next()),
                    "clEnqueueBarrierWithWaitList");
    HostRead read(queue, word, 1, kept.after_last());
    *kept.next() = read.share_event().release();
    require_success(opencl(queue).clFlush(queue), "clFlush");
    const cl_uint bits = *read.wait();
    if (!bits) return 0;
    const cl_uint none = 0;
    require_success(opencl(queue).clEnqueueFillBuffer(queue, word, &none, sizeof none, 0,
                                                      sizeof none, 0, nullptr, kept.next()),
                    "clEnqueueFillBuffer");
    require_success(opencl(queue).clFlush(queue), "clFlush");
    wait_for(*kept.after_last().events);
    return bits;
}

}  // namespace rsh
