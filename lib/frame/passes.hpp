// passes.hpp - what a frame goes through, and the descriptors of its stages without their buffers: for
// layout.cpp, which counts bytes, and memory.cpp, which names buffers.
#pragma once

#include <rsh/rsh.h>

#include <string>

#include "approximate/approximate.hpp"
#include "batches/batch_memory.hpp"

namespace rsh {

bool needs_shadows(const rsh_frame_desc& desc);
bool needs_bounces(const rsh_frame_desc& desc);
// Whether rays are traced, and not only rasterized.
bool needs_traversals(const rsh_frame_desc& desc);
// What shading and traversals need of the batches.
BatchNeeds batch_needs(const rsh_frame_desc& desc);
// Where no rays come after the camera's, there is nothing to leave out.
bool is_approximate(const rsh_frame_desc& desc);

// Of a part of the memory that each bounce has.
std::string numbered(const char* name, cl_uint bounce);

rsh_rasterize_desc rasterize_of(const rsh_frame_desc& desc);
rsh_traverse_desc traverse_of(const rsh_frame_desc& desc, cl_uint width, cl_uint height);
// Packs what blend_pixels lists; of the finest grid that it is given, most.
rsh_reduce_desc pack_listed_of(const rsh_frame_desc& desc, cl_uint step = 2);

}  // namespace rsh
