// lookback.cpp - one pass over the stream: each tile learns from those before it where it goes
// (reduce/lookback.cl). Reads every element once from memory.
#include <algorithm>

#include "reduce/launch.hpp"

namespace rsh {
namespace {

cl_uint tile_of(const Context& context, const ReduceShape& shape) {
    return has_single_items(context) ? item_tile(context, shape) : group_tile(context);
}

size_t tile_count(const Context& context, const ReduceShape& shape) {
    return std::max(1u, divided_up(shape.count, tile_of(context, shape)));
}

size_t state_count(const Context& context, const ReduceShape& shape) {
    return 1 + 2 * tile_count(context, shape);
}

class Lookback final : public Strategy {
public:
    cl_uint id() const noexcept override { return RSH_STRATEGY_LOOKBACK; }
    const char* name() const noexcept override { return "lookback"; }
    bool is_stable() const noexcept override { return true; }

    void reserve(Layout& scratch, const Context& context,
                 const ReduceShape& shape) const override {
        scratch.add_array<cl_uint>("reduce states", state_count(context, shape));
    }

    void enqueue(Recorder& recorder, const ReduceStream& stream,
                 const Scratch& scratch) const override {
        const Context& context = recorder.context();
        const ReduceShape shape = shape_of(stream);
        const cl_mem states = scratch["reduce states"];
        const auto kernel = [&](const char* name) {
            return stream.program ? KernelName{stream.program, name}
                                  : kernel_for(stream, "reduce/lookback", name);
        };
        recorder.fill(RSH_STAGE_REDUCE, states, 0,
                      state_count(context, shape) * sizeof(cl_uint));
        if (has_single_items(context))
            launch(recorder, stream, kernel("rsh_reduce_lookback_items"),
                   single_items(size_t{4} * context.caps.compute_units),
                   tile_of(context, shape), states, stream.output, stream.output_count,
                   stream.output_index);
        else
            launch(recorder, stream, kernel("rsh_reduce_lookback_group"),
                   groups(context, tile_count(context, shape)), states, stream.output,
                   stream.output_count, stream.output_index, group_words(context, 2));
    }
};

}  // namespace

const Strategy& lookback() {
    static const Lookback strategy;
    return strategy;
}

}  // namespace rsh
