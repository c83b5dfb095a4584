#include "order/sort.hpp"

#include <algorithm>

#include "order/types.h"

namespace rsh {

KernelName tiles_kernel(const char* kernel) {
    return {"programs/tiles", kernel};
}

Sort::Sort(cl_uint count, cl_uint bins, cl_uint compute_units)
    : count_(count),
      bins_(bins),
      items_(std::min({compute_units * 2, RSH_SORT_ITEMS(count, bins), 64u})) {}

void Sort::reserve(Layout& layout) const {
    layout.add_array<sample_bounds>("samples", items_);
    layout.add_array<sort_plan>("sorting", 1);
    layout.add_array<cl_uint>("keys", count_);
    layout.add_array<cl_uint>("bins", size_t{items_} * bins_);
    layout.add_array<cl_uint>("sorted", count_);
}

void Sort::run(Recorder& recorder, cl_uint stage, const Scratch& scratch, cl_mem order,
               cl_ulong first) const {
    const cl_mem sorting = scratch["sorting"], keys = scratch["keys"], bins = scratch["bins"];
    recorder.launch(stage, tiles_kernel("rsh_sort_scan"), {1, 1}, bins_, sorting, bins);
    recorder.launch(stage, tiles_kernel("rsh_sort_scatter"), items(), bins_, sorting, keys,
                    bins, order, first);
    recorder.launch(stage, tiles_kernel("rsh_sort_refine"), {size_t{16} * items_, 1}, bins_,
                    sorting, keys, bins, scratch["sorted"], order, first);
}

}  // namespace rsh
