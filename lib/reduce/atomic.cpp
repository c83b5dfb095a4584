// atomic.cpp - one atomic increment per kept element (reduce/atomic.cl): the shortest strategy,
// and what the others are there to avoid.
#include "reduce/launch.hpp"

namespace rsh {
namespace {

class Atomic final : public Strategy {
public:
    cl_uint id() const noexcept override { return RSH_STRATEGY_ATOMIC; }
    const char* name() const noexcept override { return "atomic"; }
    bool is_stable() const noexcept override { return false; }

    void reserve(Layout&, const Context&, const ReduceShape&) const override {}

    void enqueue(Recorder& recorder, const ReduceStream& stream,
                 const Scratch&) const override {
        clear_result(recorder, stream);
        launch(recorder, stream, kernel_for(stream, "reduce/atomic", "rsh_reduce_atomic"),
               recorder.stream_range(), stream.output, stream.output_count,
               stream.output_index);
    }
};

}  // namespace

const Strategy& atomic() {
    static const Atomic strategy;
    return strategy;
}

}  // namespace rsh
