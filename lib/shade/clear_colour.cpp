#include "shade/clear_colour.hpp"

#include "shade/surface_kernel.hpp"

namespace rsh {

void clear_colour(Recorder& recorder, const rsh_scene& scene, cl_mem hits, cl_uint pixel_count,
                  cl_mem colour, cl_mem hit_count) {
    recorder.launch(RSH_STAGE_SHADE, surface_kernel(scene, "rsh_clear_colour"),
                    recorder.stream_range(), hits, pixel_count, colour, hit_count);
}

}  // namespace rsh
