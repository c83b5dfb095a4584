// intersect.hpp - ray-triangle tests of surviving pairs, and the completion of what they hit.
#pragma once

#include "device/cl/recorder.hpp"

namespace rsh {

// What kernels are given for their answers; with counts and all hits, see kernels/traverse/hit_list.h.
struct Answers {
    cl_mem hits, occlusion;
    cl_uint occlusion_bit;  // as a mask; 0: closest hits are wanted
};
Answers answers_of(const rsh_traverse_desc& desc);

// Whether all hits of a ray matter, and not only the closest; and what makes a program for them.
inline bool wants_all_hits(cl_uint query) {
    return query == RSH_QUERY_COUNT || query == RSH_QUERY_ALL;
}
inline const char* all_hits_option(cl_uint query) {
    return wants_all_hits(query) ? " -D RSH_ALL_HITS=1" : "";
}

// A kernel that intersects triangles: of `program`, or for all hits and with a filter of a program of its
// own, made of the file that it is in.
KernelName hit_kernel(const rsh_traverse_desc& desc, const char* program, const char* file,
                      const char* kernel);

// Whether some hits are not seen: kernels/mesh/filter.h.
template <class Desc>
bool wants_filter(const Desc& desc) {
    return desc.ray_masks || desc.cull != RSH_CULL_NONE;
}
template <class Desc>
const char* filter_option(const Desc& desc) {
    return wants_filter(desc) ? " -D RSH_FILTER=1" : "";
}

// Whether the triangles are one batch of a scene: kernels/mesh/batch.h.
inline bool is_batch(const rsh_traverse_desc& desc) {
    return desc.continued || desc.first_triangle || desc.skip_corners;
}
inline const char* batch_option(const rsh_traverse_desc& desc) {
    return is_batch(desc) ? " -D RSH_BATCHES=1" : "";
}

// Calls `use` with what a kernel is told about the filter, or with nothing.
template <class Desc, class Use>
void with_filter(const Desc& desc, Use use) {
    if (wants_filter(desc))
        use(desc.ray_masks, desc.geometry.ranges, desc.geometry.range_count, desc.cull);
    else
        use();
}

// The same of the batch, which only a traversal has.
template <class Use>
void with_batch(const rsh_traverse_desc& desc, Use use) {
    if (is_batch(desc))
        use(desc.first_triangle, desc.continued, desc.skip_corners, desc.skip_numbers,
            desc.skip_count);
    else
        use();
}
template <class Use>
void with_batch(const rsh_audit_desc&, Use use) {
    use();
}

// Launches a kernel that intersects triangles, with filter and batch behind its other arguments.
template <class Desc, class... Arguments>
void launch_hits(Recorder& recorder, const Desc& desc, cl_uint stage, const KernelName& name,
                 const Range& range, const Arguments&... arguments) {
    with_filter(desc, [&](const auto&... filter) {
        with_batch(desc, [&](const auto&... batch) {
            recorder.launch(stage, name, range, arguments..., filter..., batch...);
        });
    });
}

// No ray has hit anything yet. The program is one that has rsh_clear_hits.
void clear_hits(Recorder& recorder, const rsh_traverse_desc& desc, const char* program);
// Intersects the pairs of level 0; `pair_count`: their number.
void intersect(Recorder& recorder, const rsh_traverse_desc& desc, cl_mem pairs,
               cl_mem pair_count);
// Fills in t, u and v.
void resolve(Recorder& recorder, const rsh_traverse_desc& desc);

}  // namespace rsh
