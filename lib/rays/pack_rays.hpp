// pack_rays.hpp - rays out of separate arrays; see rsh_trace.
#pragma once

#include "device/cl/recorder.hpp"

namespace rsh {

// What lies at each stride of an array, in bytes.
constexpr cl_uint kVectorBytes = 12, kNumberBytes = 4;

inline cl_uint stride_of(const rsh_ray_floats& floats, cl_uint bytes) {
    return floats.stride ? floats.stride : bytes;
}

// rays: out, width * height of them.
void pack_rays(Recorder& recorder, const rsh_trace_desc& desc, cl_mem rays);

}  // namespace rsh
