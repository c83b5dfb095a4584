#include "frame/strips.hpp"

#include <algorithm>

#include "device/error.hpp"
#include "frame/memory.hpp"

namespace rsh {
namespace {

// The first row of a strip begins where sub-buffers may, for any width and device: at a multiple of
// 1024 bytes.
constexpr cl_uint kLeastRows = 64;

// Of a device's memory, where the caller does not say how much.
constexpr cl_ulong kDefaultShare = 4;

cl_ulong default_budget(const DeviceCaps& caps) {
    return std::min(caps.memory / kDefaultShare, caps.max_allocation);
}

cl_uint rows_of(const rsh_frame_desc& desc, cl_uint steps) {
    return std::min(desc.height, kLeastRows * steps);
}

// The streams' share grows with the budget, by an eighth of it.
size_t least_budget(const Context& context, rsh_frame_desc desc) {
    desc.budget = 1;
    for (;;) {
        const size_t bytes = strip_scratch(context, desc, rows_of(desc, 1)).bytes();
        if (bytes <= desc.budget) return desc.budget;
        desc.budget = bytes;
    }
}

}  // namespace

cl_uint strip_rows(const Context& context, const rsh_frame_desc& desc) {
    const cl_ulong most = desc.budget ? desc.budget : default_budget(context.caps);
    const auto bytes = [&](cl_uint steps) {
        return strip_scratch(context, desc, rows_of(desc, steps)).bytes();
    };
    cl_uint fits = 0, steps = (desc.height + kLeastRows - 1) / kLeastRows;
    // All of it, mostly; else the most steps that fit.
    for (cl_uint tried = steps; fits < steps; tried = fits + (steps - fits + 1) / 2) {
        if (bytes(tried) <= most)
            fits = tried;
        else
            steps = tried - 1;
    }
    if (fits == 0 && desc.budget)
        throw Error(RSH_INVALID_VALUE, "budget: is ", desc.budget, ", must be 0 or at least ",
                    least_budget(context, desc));
    return rows_of(desc, std::max(fits, 1u));
}

}  // namespace rsh
