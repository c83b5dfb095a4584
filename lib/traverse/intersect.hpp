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

// Launches a kernel that intersects triangles, with the filter behind its other arguments.
template <class Desc, class... Arguments>
void launch_hits(Recorder& recorder, const Desc& desc, cl_uint stage, const KernelName& name,
                 const Range& range, const Arguments&... arguments) {
    if (wants_filter(desc))
        recorder.launch(stage, name, range, arguments..., desc.ray_masks, desc.geometry.ranges,
                        desc.geometry.range_count, desc.cull);
    else
        recorder.launch(stage, name, range, arguments...);
}

// No ray has hit anything yet. The program is one that has rsh_clear_hits.
void clear_hits(Recorder& recorder, const rsh_traverse_desc& desc, const char* program);
// Intersects the pairs of level 0; `pair_count`: their number.
void intersect(Recorder& recorder, const rsh_traverse_desc& desc, cl_mem pairs,
               cl_mem pair_count);
// Fills in t, u and v.
void resolve(Recorder& recorder, const rsh_traverse_desc& desc);

}  // namespace rsh
