// sort.hpp - numbers in the order of their keys (order/sort.cl), as triangles and rays need it
// before boxes are put around ranges of them. What makes the keys fills the bins as well.
#pragma once

#include "device/cl/recorder.hpp"
#include "device/cl/scratch.hpp"
#include "device/layout.hpp"

namespace rsh {

KernelName tiles_kernel(const char* kernel);

class Sort {
public:
    Sort(cl_uint count, cl_uint bins, cl_uint compute_units);

    // Work-items of the kernels that measure and make keys, each with samples and bins of its
    // own.
    Range items() const { return {items_, 1}; }

    // "samples" (sample_bounds per work-item), "sorting" (sort_plan), "keys" and "bins".
    void reserve(Layout& layout) const;

    // From this part on, what `reserve` adds is not read after `run`.
    static constexpr const char* kOnlyWhileSorting = "keys";

    // Numbers go to `order`, from word `first` on.
    void run(Recorder& recorder, cl_uint stage, const Scratch& scratch, cl_mem order,
             cl_ulong first) const;

private:
    cl_uint count_, bins_, items_;
};

}  // namespace rsh
