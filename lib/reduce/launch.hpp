// launch.hpp - what the host files of the strategies share: the shapes of launches and the
// arguments that every kernel over a stream begins with.
#pragma once

#include <algorithm>
#include <string>

#include "reduce/strategy.hpp"
#include "tuning.h"

namespace rsh {

constexpr cl_uint divided_up(cl_uint count, cl_uint size) {
    return count / size + (count % size != 0);
}

// Where a group is a task of a CPU, one work-item does a group's work: no barriers.
inline bool has_single_items(const Context& context) {
    return context.vector_width > 1;
}

inline Range single_items(size_t items) {
    return {items, 1};
}

// Ranges of elements, one per work-item. Every item adds up the counts before its own, so their
// number is bounded; a range shorter than 1024 is not worth a task.
inline Range item_ranges(const Context& context, cl_uint count) {
    const size_t group = has_single_items(context) ? 1 : context.caps.group_size;
    const size_t most = context.caps.compute_units * (group == 1 ? 16 : 4 * group);
    const size_t items = std::clamp<size_t>(count / 1024, 1, most);
    return {(items + group - 1) / group * group, group};
}

// Whole groups of the device's usual size.
inline Range groups(const Context& context, size_t count) {
    return {count * context.caps.group_size, context.caps.group_size};
}

inline cl_uint group_items(const Context& context) {
    return static_cast<cl_uint>(context.caps.group_size);
}

// Elements that a group works off at a time.
inline cl_uint group_tile(const Context& context) {
    return RSH_PER_ITEM * group_items(context);
}

// Groups of scan_scatter; a longer stream gives each several tiles.
inline cl_uint most_scan_groups(const Context& context) {
    return context.caps.compute_units * 16;
}

// Elements that a single item counts and then packs out of the cache: 128 KB, but enough tiles
// for all cores to end at about the same time. A multiple of RSH_RANGE_STEP, as reduce/range.h
// asks for.
inline cl_uint item_tile(const Context& context, const ReduceShape& shape) {
    const cl_uint fair = shape.count / (8 * context.caps.compute_units);
    const cl_uint most = (128u << 10) / shape.element_bytes;
    return std::clamp(fair, 4096u, std::max(most, 4096u)) / RSH_RANGE_STEP * RSH_RANGE_STEP;
}

// Local memory: a word per work-item for prefix sums, `more` behind them.
inline LocalBytes group_words(const Context& context, size_t more = 0) {
    return {(context.caps.group_size + more) * sizeof(cl_uint)};
}

inline ReduceShape shape_of(const ReduceStream& stream) {
    return {stream.count, stream.element_bytes};
}

inline KernelName kernel_for(const ReduceStream& stream, const char* program,
                             const char* kernel) {
    return {program, kernel,
            "-D RSH_WORDS=" + std::to_string(stream.element_bytes / 4) +
                " -D RSH_KEEP=" + std::to_string(stream.keep)};
}

template <class... More>
void launch(Recorder& recorder, const ReduceStream& stream, const KernelName& name,
            const Range& range, const More&... more) {
    const cl_uint has_input_count = stream.input_count != nullptr;
    recorder.launch(RSH_STAGE_REDUCE, name, range, stream.input, stream.flags,
                    stream.input_count, has_input_count, stream.count, more...);
}

// Counts of blocks, in place, to where their ranges begin; their sum is the stream's result.
inline void scan_counts(Recorder& recorder, const ReduceStream& stream, cl_mem counts,
                        cl_uint blocks) {
    const Context& context = recorder.context();
    recorder.launch(RSH_STAGE_REDUCE, {"reduce/scan_counts", "rsh_reduce_scan_counts"},
                    groups(context, 1), counts, blocks, stream.output_count,
                    stream.output_index, group_words(context));
}

// For strategies whose result starts at 0 and grows.
inline void clear_result(Recorder& recorder, const ReduceStream& stream) {
    recorder.fill(RSH_STAGE_REDUCE, stream.output_count, 0, sizeof(cl_uint),
                  stream.output_index * sizeof(cl_uint));
}

}  // namespace rsh
