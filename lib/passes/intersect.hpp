// intersect.hpp - ray-triangle tests of surviving pairs, and the completion of what they hit.
#pragma once

#include "cl/recorder.hpp"

namespace rsh {

// Compile-time parameters of kernels that end in hits or in an occlusion bit.
std::string query_options(const rsh_traverse_desc& desc);

// No ray has hit anything yet.
void clear_hits(Recorder& recorder, const rsh_traverse_desc& desc);
// Intersects the pairs of level 0; `pair_count`: their number.
void intersect(Recorder& recorder, const rsh_traverse_desc& desc, cl_mem pairs, cl_mem pair_count);
// Fills in t, u and v.
void resolve(Recorder& recorder, const rsh_traverse_desc& desc);

}  // namespace rsh
