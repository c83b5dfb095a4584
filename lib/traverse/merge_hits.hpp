// merge_hits.hpp - the closest hits of several batches of a scene, for engines that know of one; see
// rsh_traverse, continued.
#pragma once

#include "device/cl/recorder.hpp"

namespace rsh {

// Makes rays that end where they hit something already.
void shorten_rays(Recorder& recorder, const rsh_traverse_desc& desc, cl_mem shortened);
void merge_hits(Recorder& recorder, const rsh_traverse_desc& desc, cl_mem found);

}  // namespace rsh
