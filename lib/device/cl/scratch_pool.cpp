#include "device/cl/scratch_pool.hpp"

#include <algorithm>

#include "device/objects/waiting.hpp"

namespace rsh {
namespace {

bool is_in_order(cl_command_queue queue) {
    return !(info<cl_command_queue_properties>(queue, CL_QUEUE_PROPERTIES) &
             CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE);
}

}  // namespace

// Waiting for the block's last user instead would make the call depend on an event that its
// caller never named: one that the application may set only after this call, or that is on a
// queue nobody flushed.
ScratchBlock ScratchPool::borrow(size_t bytes, cl_command_queue queue, const Waits& waits) {
    const bool in_order = is_in_order(queue);
    const auto is_free = [&](const ScratchBlock& block) {
        const cl_event last = block.last_use.get();
        if (!last || has_ended(last)) return true;
        if (in_order && info<cl_command_queue>(last, CL_EVENT_COMMAND_QUEUE) == queue)
            return true;
        return std::find(waits.events, waits.events + waits.count, last) !=
               waits.events + waits.count;
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
    ScratchBlock block{new_buffer(context_, CL_MEM_READ_WRITE, bytes), bytes, {}};
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

void ScratchPool::give_up(ScratchBlock block) noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    bytes_ -= block.bytes;
    --count_;
}

size_t ScratchPool::bytes() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return bytes_;
}

}  // namespace rsh
