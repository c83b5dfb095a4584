#include "cl/scratch_pool.hpp"

#include <algorithm>

namespace rsh {

ScratchBlock ScratchPool::borrow(size_t bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto fits = [bytes](const ScratchBlock& block) { return block.bytes >= bytes; };
    const auto found = std::find_if(idle_.begin(), idle_.end(), fits);
    if (found != idle_.end()) {
        ScratchBlock block = std::move(*found);
        idle_.erase(found);
        return block;
    }
    if (!idle_.empty()) {
        bytes_ -= idle_.back().bytes;
        idle_.pop_back();
    }
    ScratchBlock block{cl::Buffer(context_, CL_MEM_READ_WRITE, bytes), bytes, {}};
    bytes_ += bytes;
    return block;
}

void ScratchPool::give_back(ScratchBlock block) {
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
