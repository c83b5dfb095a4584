#include "traverse/audit.hpp"

#include <algorithm>

#include "mesh/mesh.hpp"
#include "traverse/intersect.hpp"

namespace rsh {

void clear_report(Recorder& recorder, cl_mem report) {
    recorder.fill(RSH_STAGE_OTHER, report, 0, sizeof(rsh_audit_report));
    recorder.fill(RSH_STAGE_OTHER, report, RSH_NO_HIT, sizeof(cl_uint),
                  offsetof(rsh_audit_report, first_ray));
}

void audit(Recorder& recorder, const rsh_audit_desc& desc) {
    const rsh_geometry& geometry = desc.geometry;
    const cl_uint sample = desc.sample ? std::min(desc.sample, desc.ray_count) : desc.ray_count;
    const cl_uint bit = desc.query == RSH_QUERY_ANY ? cl_uint{1} << desc.occlusion_bit : 0;
    if (sample == 0) return;
    const cl_mem none = nullptr;
    launch_hits(recorder, desc, RSH_STAGE_OTHER,
                {"traverse/audit", "rsh_audit",
                 std::string(all_hits_option(desc.query)) + filter_option(desc)},
                recorder.stream_range(), mesh_view_of(geometry), geometry.vertices,
                geometry.indices, desc.rays, desc.skip, desc.ray_count, desc.list_count,
                desc.hits, desc.occlusion, bit,
                desc.query == RSH_QUERY_COUNT ? desc.hit_counts : none,
                desc.query == RSH_QUERY_ALL ? desc.hit_offsets : none, desc.hit_capacity,
                sample, desc.seed, desc.report);
}

}  // namespace rsh
