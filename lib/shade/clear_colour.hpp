// clear_colour.hpp - begins a frame's image (shade/clear_colour.cl) and counts its primary
// hits.
#pragma once

#include "device/cl/recorder.hpp"

namespace rsh {

// `hit_count`: one cl_uint that grows by the pixels with a hit.
void clear_colour(Recorder& recorder, const rsh_scene& scene, cl_mem hits, cl_uint pixel_count,
                  cl_mem colour, cl_mem hit_count);

}  // namespace rsh
