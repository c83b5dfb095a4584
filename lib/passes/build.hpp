// build.hpp - the hierarchy over the rays (build.cl) and its shape.
#pragma once

#include "cl/recorder.hpp"

namespace rsh {

rsh_levels levels_of(cl_uint width, cl_uint height);
cl_ulong ray_count(const rsh_levels& levels);
size_t node_bytes(const rsh_levels& levels);

void build(Recorder& recorder, const rsh_build_desc& desc);

}  // namespace rsh
