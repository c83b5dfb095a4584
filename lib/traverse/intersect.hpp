// intersect.hpp - ray-triangle tests of surviving pairs, and the completion of what they hit.
#pragma once

#include "device/cl/recorder.hpp"

namespace rsh {

// The bit to set where a ray hits something; 0: closest hits are wanted.
cl_uint occlusion_mask(const rsh_traverse_desc& desc);

// No ray has hit anything yet. The program is one that has traverse/clear_hits.cl.
void clear_hits(Recorder& recorder, const rsh_traverse_desc& desc, const char* program);
// Intersects the pairs of level 0; `pair_count`: their number.
void intersect(Recorder& recorder, const rsh_traverse_desc& desc, cl_mem pairs,
               cl_mem pair_count);
// Fills in t, u and v.
void resolve(Recorder& recorder, const rsh_traverse_desc& desc);

}  // namespace rsh
