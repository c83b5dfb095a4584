// chunk.cpp - one range of elements per work-item (reduce/chunk.cl): count, then write; a short
// stream by one work-item at once. No barrier, no local memory: safe on any driver, and quick
// where cores are few and caches large.
#include "reduce/launch.hpp"

namespace rsh {
namespace {

// Up to here one core is done before a second launch would begin.
bool is_short(const Context& context, cl_uint count) {
    return count <= (has_single_items(context) ? 1u << 16 : 1u << 10);
}

class Chunk final : public Strategy {
public:
    cl_uint id() const noexcept override { return RSH_STRATEGY_CHUNK; }
    const char* name() const noexcept override { return "chunk"; }
    bool is_stable() const noexcept override { return true; }

    void reserve(Layout& scratch, const Context& context,
                 const ReduceShape& shape) const override {
        if (!is_short(context, shape.count))
            scratch.add_array<cl_uint>("reduce counts",
                                       item_ranges(context, shape.count).items);
    }

    void enqueue(Recorder& recorder, const ReduceStream& stream,
                 const Scratch& scratch) const override {
        const Context& context = recorder.context();
        const auto kernel = [&](const char* name) {
            return stream.program ? KernelName{stream.program, name}
                                  : kernel_for(stream, "reduce/chunk", name);
        };
        if (is_short(context, stream.count)) {
            launch(recorder, stream, kernel("rsh_reduce_chunk_alone"), single_items(1),
                   stream.output, stream.output_count, stream.output_index);
            return;
        }
        const Range range = item_ranges(context, stream.count);
        const cl_mem counts = scratch["reduce counts"];
        launch(recorder, stream, kernel("rsh_reduce_chunk_count"), range, counts);
        launch(recorder, stream, kernel("rsh_reduce_chunk_write"), range, counts, stream.output,
               stream.output_count, stream.output_index);
    }
};

}  // namespace

const Strategy& chunk() {
    static const Chunk strategy;
    return strategy;
}

}  // namespace rsh
