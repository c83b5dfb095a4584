// describe_hits.hpp - what else a caller wants to know of hits that were found.
#pragma once

#include "device/cl/recorder.hpp"

namespace rsh {

// What is wanted, as in rsh_trace_desc; NULL: it is not.
struct HitDescriptions {
    cl_mem normals, points, geometry_ids;
};

// desc: of the traversal that found the hits.
void describe_hits(Recorder& recorder, const rsh_traverse_desc& desc,
                   const HitDescriptions& wanted);

}  // namespace rsh
