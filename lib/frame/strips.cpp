#include "frame/strips.hpp"

#include <algorithm>

#include "batches/batch_memory.hpp"
#include "device/error.hpp"
#include "frame/memory.hpp"

namespace rsh {
namespace {

// The first row of a strip begins where sub-buffers may, for any width and device: at a multiple of
// 1024 bytes.
constexpr cl_uint kLeastRows = 64;

cl_uint rows_of(const rsh_frame_desc& desc, cl_uint steps) {
    return std::min(desc.height, kLeastRows * steps);
}

// So few triangles to a batch do not cost much time; before fewer are taken, strips are made lower.
constexpr cl_uint kUsefulBatch = 1u << 16;

cl_uint least_triangles(const rsh_frame_desc& desc) {
    return desc.batches ? least_batch_triangles(*desc.batches) : 0;
}

cl_uint useful_triangles(const rsh_frame_desc& desc) {
    return desc.batches ? std::min(most_batch_triangles(*desc.batches), kUsefulBatch) : 0;
}

// The streams' share grows with the budget, by an eighth of it.
size_t least_budget(const Context& context, rsh_frame_desc desc) {
    const StripSize least = {rows_of(desc, 1), least_triangles(desc)};
    desc.budget = 1;
    for (;;) {
        const size_t bytes = strip_scratch(context, desc, least).bytes();
        if (bytes <= desc.budget) return desc.budget;
        desc.budget = bytes;
    }
}

// All of it, mostly; else the most rows that fit, with batches of so many triangles; 0: none.
cl_uint fitting_rows(const Context& context, const rsh_frame_desc& desc, cl_uint triangles,
                     cl_ulong budget) {
    cl_uint fits = 0, steps = (desc.height + kLeastRows - 1) / kLeastRows;
    for (cl_uint tried = steps; fits < steps; tried = fits + (steps - fits + 1) / 2) {
        const StripSize size = {rows_of(desc, tried), triangles};
        if (strip_scratch(context, desc, size).bytes() <= budget)
            fits = tried;
        else
            steps = tried - 1;
    }
    return fits == 0 ? 0 : rows_of(desc, fits);
}

}  // namespace

StripSize strip_size(const Context& context, const rsh_frame_desc& desc) {
    const cl_ulong budget = desc.budget ? desc.budget : context.caps.usual_budget();
    StripSize size = {fitting_rows(context, desc, useful_triangles(desc), budget),
                      least_triangles(desc)};
    bool fits = size.rows > 0;
    if (!fits) size.rows = rows_of(desc, 1);
    if (desc.batches) {
        const cl_uint triangles = fitting_triangles(*desc.batches, budget, [&](cl_uint tried) {
            return strip_scratch(context, desc, {size.rows, tried}).bytes();
        });
        fits = triangles > 0 || (fits && size.triangles == 0);
        if (triangles > 0) size.triangles = triangles;
    }
    if (!fits && desc.budget)
        throw Error(RSH_INVALID_VALUE, "budget: is ", desc.budget, ", must be 0 or at least ",
                    least_budget(context, desc));
    return size;
}

}  // namespace rsh
