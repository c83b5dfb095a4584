// scratch_pool.hpp - device memory for calls that bring none. A block is lent to one call at a
// time, and only to a call that need not wait for its last user: two queues get two blocks.
// Blocks grow and are kept; a call on a queue that worked before allocates nothing.
#pragma once

#include <mutex>
#include <vector>

#include "device/objects/handle.hpp"

namespace rsh {

struct ScratchBlock {
    Buffer buffer;
    size_t bytes = 0;
    Event last_use;  // null: never used
};

class ScratchPool {
public:
    explicit ScratchPool(cl_context context) : context_(context) {}

    // For commands on `queue` after `waits`: the smallest block free for them that holds
    // `bytes`; else the largest free one is replaced.
    ScratchBlock borrow(size_t bytes, cl_command_queue queue, const Waits& waits);
    void give_back(ScratchBlock block) noexcept;
    // Where nobody will know when commands are done with it. OpenCL keeps it until then.
    void give_up(ScratchBlock block) noexcept;
    size_t bytes() const;

private:
    cl_context context_;
    mutable std::mutex mutex_;
    std::vector<ScratchBlock> idle_;  // by size; has room for what is lent
    size_t count_ = 0;                // idle and lent
    size_t bytes_ = 0;
};

}  // namespace rsh
