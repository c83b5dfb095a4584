// ray_sample.cpp - the definition of an active ray, written from rsh_types.h.
#include "device/ray_sample.hpp"

#include <cmath>

namespace render {

bool is_active(const rsh_ray& ray) {
    const cl_float* o = ray.origin_tmin.s;
    const cl_float* d = ray.direction_tmax.s;
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(o[i]) || !std::isfinite(d[i])) return false;
    return (d[0] != 0.0f || d[1] != 0.0f || d[2] != 0.0f) && o[3] <= d[3];
}

RaySample sample_rays(const std::vector<rsh_ray>& wave, size_t step) {
    RaySample sample;
    size_t active = 0;
    for (size_t i = 0; i < wave.size(); ++i) {
        if (!is_active(wave[i]) || active++ % step != 0) continue;
        sample.rays.push_back(wave[i]);
        sample.index.push_back(i);
    }
    return sample;
}

}  // namespace render
