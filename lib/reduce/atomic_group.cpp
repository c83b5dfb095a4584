// atomic_group.cpp - one atomic addition per tile (reduce/atomic_group.cl).
#include "reduce/launch.hpp"

namespace rsh {
namespace {

class AtomicGroup final : public Strategy {
public:
    cl_uint id() const noexcept override { return RSH_STRATEGY_ATOMIC_GROUP; }
    const char* name() const noexcept override { return "atomic_group"; }
    bool is_stable() const noexcept override { return false; }

    void reserve(Layout&, const Context&, const ReduceShape&) const override {}

    void enqueue(Recorder& recorder, const ReduceStream& stream,
                 const Scratch&) const override {
        const Context& context = recorder.context();
        const Range range = recorder.stream_range();
        const char* program = "reduce/atomic_group";
        clear_result(recorder, stream);
        if (has_single_items(context))
            launch(recorder, stream,
                   kernel_for(stream, program, "rsh_reduce_atomic_group_items"), range,
                   item_tile(context, shape_of(stream)), stream.output, stream.output_count,
                   stream.output_index);
        else
            launch(recorder, stream, kernel_for(stream, program, "rsh_reduce_atomic_group"),
                   range, stream.output, stream.output_count, stream.output_index,
                   group_words(context, 1));
    }
};

}  // namespace

const Strategy& atomic_group() {
    static const AtomicGroup strategy;
    return strategy;
}

}  // namespace rsh
