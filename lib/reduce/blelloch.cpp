// blelloch.cpp - work-efficient prefix sum, then scatter (reduce/blelloch.cl): two launches per
// bit of the count.
#include "reduce/launch.hpp"

namespace rsh {
namespace {

// Of the tree over the longest stream: the next power of two.
cl_uint leaf_count(cl_uint count) {
    cl_uint leaves = 1;
    while (leaves < count) leaves *= 2;
    return leaves;
}

class Blelloch final : public Strategy {
public:
    cl_uint id() const noexcept override { return RSH_STRATEGY_BLELLOCH; }
    const char* name() const noexcept override { return "blelloch"; }
    bool is_stable() const noexcept override { return true; }

    void reserve(Layout& scratch, const Context&, const ReduceShape& shape) const override {
        scratch.add_array<cl_uint>("reduce sums", leaf_count(shape.count));
    }

    void enqueue(Recorder& recorder, const ReduceStream& stream,
                 const Scratch& scratch) const override {
        const Range range = recorder.stream_range();
        const cl_mem sums = scratch["reduce sums"];
        const cl_uint leaves = leaf_count(stream.count);
        const auto kernel = [&](const char* name) {
            return kernel_for(stream, "reduce/blelloch", name);
        };
        launch(recorder, stream, kernel("rsh_reduce_blelloch_begin"), range, sums);
        for (cl_uint half = 1; half < leaves; half *= 2)
            launch(recorder, stream, kernel("rsh_reduce_blelloch_up"), range, half, sums);
        launch(recorder, stream, kernel("rsh_reduce_blelloch_root"), single_items(1), sums,
               stream.output_count, stream.output_index);
        for (cl_uint half = leaves / 2; half > 0; half /= 2)
            launch(recorder, stream, kernel("rsh_reduce_blelloch_down"), range, half, sums);
        launch(recorder, stream, kernel("rsh_reduce_blelloch_scatter"), range, sums,
               stream.output);
    }
};

}  // namespace

const Strategy& blelloch() {
    static const Blelloch strategy;
    return strategy;
}

}  // namespace rsh
