#include "rays/pack_rays.hpp"

#include "rays/levels.hpp"
#include "rays/types.h"

namespace rsh {
namespace {

ray_floats_view view_of(const rsh_ray_floats& floats, cl_uint bytes) {
    const cl_ulong first = floats.offset / 4;
    return {static_cast<cl_uint>(first), static_cast<cl_uint>(first >> 32),
            stride_of(floats, bytes) / 4, 0};
}

}  // namespace

void pack_rays(Recorder& recorder, const rsh_trace_desc& desc, cl_mem rays) {
    const cl_uint count = static_cast<cl_uint>(ray_count(desc.width, desc.height));
    recorder.launch(RSH_STAGE_OTHER, {"rays/pack_rays", "rsh_pack_rays"},
                    recorder.stream_range(count), count, desc.list_count, desc.origins.buffer,
                    view_of(desc.origins, kVectorBytes), desc.directions.buffer,
                    view_of(desc.directions, kVectorBytes), desc.tmin.buffer,
                    view_of(desc.tmin, kNumberBytes), desc.tmax.buffer,
                    view_of(desc.tmax, kNumberBytes), rays);
}

}  // namespace rsh
