// horn.cpp - log-step compaction (reduce/horn.cl): as many launches as the count has bits.
#include <algorithm>
#include <utility>

#include "reduce/launch.hpp"

namespace rsh {
namespace {

class Horn final : public Strategy {
public:
    cl_uint id() const noexcept override { return RSH_STRATEGY_HORN; }
    const char* name() const noexcept override { return "horn"; }
    bool is_stable() const noexcept override { return true; }

    void reserve(Layout& scratch, const Context&, const ReduceShape& shape) const override {
        scratch.add_array<cl_uint>("reduce sums", std::max(shape.count, 1u));
        scratch.add_array<cl_uint>("reduce next sums", std::max(shape.count, 1u));
    }

    void enqueue(Recorder& recorder, const ReduceStream& stream,
                 const Scratch& scratch) const override {
        const Range range = recorder.stream_range();
        const auto kernel = [&](const char* name) {
            return kernel_for(stream, "reduce/horn", name);
        };
        cl_mem sums = scratch["reduce sums"], next = scratch["reduce next sums"];
        launch(recorder, stream, kernel("rsh_reduce_horn_begin"), range, sums);
        for (cl_uint step = 1; step < stream.count; step *= 2) {
            launch(recorder, stream, kernel("rsh_reduce_horn_step"), range, step, sums, next);
            std::swap(sums, next);
        }
        launch(recorder, stream, kernel("rsh_reduce_horn_gather"), range, sums, stream.output,
               stream.output_count, stream.output_index);
    }
};

}  // namespace

const Strategy& horn() {
    static const Horn strategy;
    return strategy;
}

}  // namespace rsh
