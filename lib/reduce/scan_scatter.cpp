#include "reduce/scan_scatter.hpp"

#include <algorithm>

namespace rsh {
namespace {

Range groups_for(const Context& context, cl_uint count) {
    const size_t group = context.caps.group_size;
    const size_t most = context.caps.compute_units * size_t{16};
    const size_t groups = std::clamp<size_t>((count + group - 1) / group, 1, most);
    return {groups * group, group};
}

}  // namespace

void ScanScatter::reserve(Layout& scratch, const Context& context, cl_uint count) const {
    const Range range = groups_for(context, count);
    scratch.add_array<cl_uint>("reduce counts", range.items / range.group_size);
}

void ScanScatter::enqueue(Recorder& recorder, const ReduceStream& stream,
                          const Scratch& scratch) const {
    const Range range = groups_for(recorder.context(), stream.count);
    const cl_uint groups = static_cast<cl_uint>(range.items / range.group_size);
    const char* program = "reduce_scan_scatter";
    const cl_uint has_input_count = stream.input_count != nullptr;
    const cl_mem counts = scratch["reduce counts"];
    const cl::LocalSpaceArg sums = cl::Local(range.group_size * sizeof(cl_uint));
    recorder.launch(RSH_STAGE_REDUCE,
                    reduce_kernel(stream, program, "rsh_reduce_scan_scatter_count"), range,
                    stream.input, stream.flags, stream.input_count, has_input_count,
                    stream.count, counts, sums);
    recorder.launch(RSH_STAGE_REDUCE,
                    reduce_kernel(stream, program, "rsh_reduce_scan_scatter_scan"),
                    {range.group_size, range.group_size}, counts, groups, stream.output_count,
                    stream.output_index, sums);
    recorder.launch(RSH_STAGE_REDUCE,
                    reduce_kernel(stream, program, "rsh_reduce_scan_scatter_write"), range,
                    stream.input, stream.flags, stream.input_count, has_input_count,
                    stream.count, counts, stream.output, sums);
}

}  // namespace rsh
