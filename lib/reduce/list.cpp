#include "device/error.hpp"
#include "reduce/strategy.hpp"

namespace rsh {

#define RSH_ROW(strategy) const Strategy& strategy();
#include "reduce/list.inc"
#undef RSH_ROW

Choices<Strategy> strategies() {
    static const Strategy* const all[] = {
#define RSH_ROW(strategy) &strategy(),
#include "reduce/list.inc"
#undef RSH_ROW
    };
    return all;
}

const Strategy& find_strategy(cl_uint id) {
    if (id == RSH_STRATEGY_DEFAULT) return automatic();
    for (const Strategy* strategy : strategies())
        if (strategy->id() == id) return *strategy;
    throw Error(RSH_INVALID_VALUE, "strategy: is ", id, ", must be RSH_STRATEGY_...");
}

cl_uint chosen_strategy(const Context& context, cl_uint id, cl_uint count) {
    const cl_uint unsafe = context.unsafe_strategies;
    const Strategy& strategy = find_strategy(id).chosen(context, count, unsafe);
    if (unsafe >> strategy.id() & 1)
        throw Error(RSH_UNSUPPORTED, "strategy: is ", strategy.name(),
                    ", which rsh_device_selftest found to be wrong on this device; must be "
                    "another one");
    return strategy.id();
}

Layout reduce_scratch(const Context& context, const rsh_reduce_desc& desc) {
    Layout scratch(context.caps.alignment);
    find_strategy(desc.strategy).reserve(scratch, context, {desc.count, desc.element_bytes});
    return scratch;
}

void reduce(Recorder& recorder, const rsh_reduce_desc& desc) {
    const Scratch scratch(recorder, reduce_scratch(recorder.context(), desc), desc.scratch);
    const ReduceStream stream = {
        desc.keep,   desc.element_bytes, desc.count, desc.input_count, desc.input, desc.flags,
        desc.output, desc.output_count,  0,          nullptr};
    find_strategy(desc.strategy).enqueue(recorder, stream, scratch);
}

}  // namespace rsh
