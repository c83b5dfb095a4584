// check_reduce.cpp - the stream of rsh_reduce.
#include "api/check_fields.hpp"
#include "reduce/strategy.hpp"

namespace rsh {
namespace {

// An index plus the step to a work-item's next element stays below 2^32.
constexpr cl_uint kMaxElements = 1u << 31;

}  // namespace

void check_shape(const rsh_reduce_desc& desc) {
    find_strategy(desc.strategy);
    require(desc.keep <= RSH_KEEP_BITS, "keep", desc.keep, "RSH_KEEP_...");
    const cl_uint bytes = desc.element_bytes;
    require(bytes == 4 || bytes == 8 || bytes == 12 || bytes == 16, "element_bytes", bytes,
            "4, 8, 12 or 16");
    require(desc.count <= kMaxElements, "count", desc.count, "at most ", kMaxElements);
}

void check_buffers(const Context& context, const rsh_reduce_desc& desc) {
    Buffers buffers(context);
    const cl_ulong bytes = desc.element_bytes;
    buffers.optional_in("input_count", desc.input_count, 4);
    buffers.in("input", desc.input, desc.count * bytes);
    if (desc.keep == RSH_KEEP_FLAGS) buffers.in("flags", desc.flags, desc.count);
    if (desc.keep == RSH_KEEP_BITS)
        buffers.in("flags", desc.flags, (cl_ulong{desc.count} + 7) / 8);
    buffers.out("output", desc.output, desc.count ? bytes : 0);
    buffers.out("output_count", desc.output_count, 4);
    buffers.scratch(desc.scratch, reduce_scratch(context, desc).bytes());
}

}  // namespace rsh
