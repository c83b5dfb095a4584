#include "reduce/chunk.hpp"

#include <algorithm>

namespace rsh {
namespace {

// Every work-item adds up the counts before its own, so their number is bounded; a run shorter
// than this is not worth a task.
constexpr cl_uint kShortestRun = 1024;

Range runs(const Context& context, cl_uint count) {
    const bool is_cpu = context.vector_width > 1;
    const size_t group = is_cpu ? 1 : context.caps.group_size;
    const size_t most = context.caps.compute_units * (is_cpu ? 16 : 4 * group);
    const size_t items = std::clamp<size_t>(count / kShortestRun, 1, most);
    return {(items + group - 1) / group * group, group};
}

}  // namespace

void Chunk::reserve(Layout& scratch, const Context& context, cl_uint count) const {
    scratch.add_array<cl_uint>("reduce counts", runs(context, count).items);
}

void Chunk::enqueue(Recorder& recorder, const ReduceStream& stream,
                    const Scratch& scratch) const {
    const Range range = runs(recorder.context(), stream.count);
    const char* program = "reduce_chunk";
    const cl_uint has_input_count = stream.input_count != nullptr;
    const cl_mem counts = scratch["reduce counts"];
    recorder.launch(RSH_STAGE_REDUCE, reduce_kernel(stream, program, "rsh_reduce_chunk_count"),
                    range, stream.input, stream.flags, stream.input_count, has_input_count,
                    stream.count, counts);
    recorder.launch(RSH_STAGE_REDUCE, reduce_kernel(stream, program, "rsh_reduce_chunk_write"),
                    range, stream.input, stream.flags, stream.input_count, has_input_count,
                    stream.count, counts, stream.output, stream.output_count,
                    stream.output_index);
}

}  // namespace rsh
