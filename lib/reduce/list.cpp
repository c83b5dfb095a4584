#include "core/error.hpp"
#include "reduce/chunk.hpp"
#include "reduce/scan_scatter.hpp"
#include "reduce/strategy.hpp"

namespace rsh {

// The first one is the default.
const std::vector<const Strategy*>& strategies() {
    static const Chunk chunk;
    static const ScanScatter scan_scatter;
    static const std::vector<const Strategy*> all = {&chunk, &scan_scatter};
    return all;
}

const Strategy& find_strategy(cl_uint id) {
    if (id == RSH_STRATEGY_DEFAULT) return *strategies().front();
    for (const Strategy* strategy : strategies())
        if (strategy->id() == id) return *strategy;
    throw Error(RSH_INVALID_VALUE,
                "strategy: is " + std::to_string(id) + ", must be RSH_STRATEGY_...");
}

KernelName reduce_kernel(const ReduceStream& stream, const char* program, const char* kernel) {
    const bool has_flags = stream.keep == RSH_KEEP_FLAGS;
    if (stream.element_bytes == sizeof(rsh_pair) && !has_flags)
        return {"program_traverse", kernel};
    return {program, kernel,
            "-D RSH_WORDS=" + std::to_string(stream.element_bytes / 4) +
                " -D RSH_FLAGS=" + (has_flags ? "1" : "0")};
}

Layout reduce_scratch(const Context& context, const rsh_reduce_desc& desc) {
    Layout scratch(context.caps.alignment);
    find_strategy(desc.strategy).reserve(scratch, context, desc.count);
    return scratch;
}

void reduce(Recorder& recorder, const rsh_reduce_desc& desc) {
    const Scratch scratch(recorder, reduce_scratch(recorder.context(), desc), desc.scratch);
    const ReduceStream stream = {desc.keep,        desc.element_bytes, desc.count,
                                 desc.input_count, desc.input,         desc.flags,
                                 desc.output,      desc.output_count,  0};
    find_strategy(desc.strategy).enqueue(recorder, stream, scratch);
}

}  // namespace rsh
