// ray_sample.hpp - picks active rays out of a wave. Traces none.
#pragma once

#include <rsh/rsh_types.h>

#include <cstddef>
#include <vector>

namespace render {

// What rsh_types.h calls an active ray.
bool is_active(const rsh_ray& ray);

struct RaySample {
    std::vector<rsh_ray> rays;
    std::vector<size_t> index;  // of each in the wave
};

// Every `step`-th of the active rays, the first included.
RaySample sample_rays(const std::vector<rsh_ray>& wave, size_t step);

}  // namespace render
