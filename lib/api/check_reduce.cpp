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
    require(desc.count <= kMaxElements, "count", desc.count,
            "at most " + std::to_string(kMaxElements));
}

void check_buffers(const Context& context, const rsh_reduce_desc& desc) {
    const cl_ulong bytes = desc.element_bytes;
    check_optional(context, "input_count", desc.input_count, 4);
    check_buffer(context, "input", desc.input, desc.count * bytes);
    if (desc.keep == RSH_KEEP_FLAGS) check_buffer(context, "flags", desc.flags, desc.count);
    if (desc.keep == RSH_KEEP_BITS)
        check_buffer(context, "flags", desc.flags, (cl_ulong{desc.count} + 7) / 8);
    check_buffer(context, "output", desc.output, desc.count ? bytes : 0);
    check_buffer(context, "output_count", desc.output_count, 4);
    check_scratch(context, desc.scratch, reduce_scratch(context, desc).bytes());
}

}  // namespace rsh
