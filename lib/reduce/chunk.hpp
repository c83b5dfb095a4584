// chunk.hpp - one run of elements per work-item (reduce_chunk.cl): count, then write. No
// barrier, no local memory: safe on any driver, and quick where cores are few and caches large.
#pragma once

#include "reduce/strategy.hpp"

namespace rsh {

class Chunk final : public Strategy {
public:
    cl_uint id() const noexcept override { return RSH_STRATEGY_CHUNK; }
    const char* name() const noexcept override { return "chunk"; }
    void reserve(Layout& scratch, const Context& context, cl_uint count) const override;
    void enqueue(Recorder& recorder, const ReduceStream& stream,
                 const Scratch& scratch) const override;
};

}  // namespace rsh
