#include "device/cl/scratch_pool.hpp"

#include <algorithm>

namespace rsh {
namespace {

bool is_in_order(const cl::CommandQueue& queue) {
    return !(queue.getInfo<CL_QUEUE_PROPERTIES>() & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE);
}

// Ended, also by a failure.
bool has_ended(const cl::Event& event) {
    return event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() <= CL_COMPLETE;
}

cl_command_queue queue_of(const cl::Event& event) {
    cl_command_queue queue = nullptr;
    clGetEventInfo(event(), CL_EVENT_COMMAND_QUEUE, sizeof queue, &queue, nullptr);
    return queue;
}

}  // namespace

// Waiting for the block's last user instead would make the call depend on an event that its
// caller never named: one that the application may set only after this call, or that is on a
// queue nobody flushed.
ScratchBlock ScratchPool::borrow(size_t bytes, const cl::CommandQueue& queue,
                                 const std::vector<cl::Event>& waits) {
    const bool in_order = is_in_order(queue);
    const auto is_free = [&](const ScratchBlock& block) {
        const cl::Event& last = block.last_use;
        if (!last() || has_ended(last) || (in_order && queue_of(last) == queue())) return true;
        return std::any_of(waits.begin(), waits.end(),
                           [&](const cl::Event& wait) { return wait() == last(); });
    };
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = std::find_if(idle_.begin(), idle_.end(), [&](const ScratchBlock& block) {
        return block.bytes >= bytes && is_free(block);
    });
    if (found != idle_.end()) {
        ScratchBlock block = std::move(*found);
        idle_.erase(found);
        return block;
    }
    const auto replaced = std::find_if(idle_.rbegin(), idle_.rend(), is_free);
    if (replaced != idle_.rend()) {
        bytes_ -= replaced->bytes;
        --count_;
        idle_.erase(std::next(replaced).base());
    }
    idle_.reserve(count_ + 1);
    ScratchBlock block{cl::Buffer(context_, CL_MEM_READ_WRITE, bytes), bytes, {}};
    bytes_ += bytes;
    ++count_;
    return block;
}

void ScratchPool::give_back(ScratchBlock block) noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto larger = [](const ScratchBlock& a, const ScratchBlock& b) {
        return a.bytes < b.bytes;
    };
    idle_.insert(std::upper_bound(idle_.begin(), idle_.end(), block, larger), std::move(block));
}

size_t ScratchPool::bytes() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return bytes_;
}

}  // namespace rsh
