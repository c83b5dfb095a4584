// scan_scatter.hpp - prefix sums in work-groups, then scatter (reduce_scan_scatter.cl). The
// usual choice on devices with many small cores.
#pragma once

#include "reduce/strategy.hpp"

namespace rsh {

class ScanScatter final : public Strategy {
public:
    cl_uint id() const noexcept override { return RSH_STRATEGY_SCAN_SCATTER; }
    const char* name() const noexcept override { return "scan_scatter"; }
    void reserve(Layout& scratch, const Context& context, cl_uint count) const override;
    void enqueue(Recorder& recorder, const ReduceStream& stream,
                 const Scratch& scratch) const override;
};

}  // namespace rsh
