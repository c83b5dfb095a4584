// scratch_pool.hpp - device memory for calls that bring none. A block is lent to one call at a time;
// with it comes the event after which its last user is done. Blocks grow and are kept.
#pragma once

#include <mutex>
#include <vector>

#include "cl/opencl.hpp"

namespace rsh {

struct ScratchBlock {
    cl::Buffer buffer;
    size_t bytes = 0;
    cl::Event last_use;  // null: free at once
};

class ScratchPool {
public:
    explicit ScratchPool(cl::Context context) : context_(std::move(context)) {}

    // The smallest idle block that holds `bytes`; else the largest idle one is replaced.
    ScratchBlock borrow(size_t bytes);
    void give_back(ScratchBlock block);
    size_t bytes() const;

private:
    cl::Context context_;
    mutable std::mutex mutex_;
    std::vector<ScratchBlock> idle_;
    size_t bytes_ = 0;
};

}  // namespace rsh
