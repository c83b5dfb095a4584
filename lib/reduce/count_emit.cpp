// count_emit.cpp - decides once, into a bit per element (reduce/count_emit.cl), then emits what
// the bits keep (reduce/chunk.cl). Reads elements twice only where they are kept.
#include "reduce/launch.hpp"

namespace rsh {
namespace {

class CountEmit final : public Strategy {
public:
    cl_uint id() const noexcept override { return RSH_STRATEGY_COUNT_EMIT; }
    const char* name() const noexcept override { return "count_emit"; }
    bool is_stable() const noexcept override { return true; }

    void reserve(Layout& scratch, const Context& context,
                 const ReduceShape& shape) const override {
        scratch.add("reduce bits", size_t{shape.count} / 8 + 1);
        scratch.add_array<cl_uint>("reduce counts", item_ranges(context, shape.count).items);
    }

    void enqueue(Recorder& recorder, const ReduceStream& stream,
                 const Scratch& scratch) const override {
        const Range range = item_ranges(recorder.context(), stream.count);
        const cl_mem counts = scratch["reduce counts"];
        ReduceStream decided = stream;
        decided.keep = RSH_KEEP_BITS;
        decided.flags = scratch["reduce bits"];
        launch(recorder, stream,
               kernel_for(stream, "reduce/count_emit", "rsh_reduce_count_emit_count"), range,
               decided.flags, counts);
        launch(recorder, decided, kernel_for(decided, "reduce/chunk", "rsh_reduce_chunk_write"),
               range, counts, stream.output, stream.output_count, stream.output_index);
    }
};

}  // namespace

const Strategy& count_emit() {
    static const CountEmit strategy;
    return strategy;
}

}  // namespace rsh
