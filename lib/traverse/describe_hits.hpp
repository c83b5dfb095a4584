// describe_hits.hpp - what else a caller wants to know of hits that were found.
#pragma once

#include "device/cl/recorder.hpp"

namespace rsh {

// desc: of the traversal that found the hits. normals, geometry_ids: NULL: nobody wants them.
void describe_hits(Recorder& recorder, const rsh_traverse_desc& desc, cl_mem normals,
                   cl_mem geometry_ids);

}  // namespace rsh
