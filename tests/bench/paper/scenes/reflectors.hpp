// reflectors.hpp - how many reflecting things a picture shows.
#pragma once

#include <rsh/rsh_types.h>

#include "frame/still_scene.hpp"

namespace bench::paper {

// Things are triangles of a material that reflects or transmits and that hang together by corners at the
// same place. hits: what the camera's rays meet.
size_t count_reflectors(const StillScene& scene, const std::vector<rsh_hit>& hits);

}  // namespace bench::paper
