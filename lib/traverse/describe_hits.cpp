#include "traverse/describe_hits.hpp"

#include "mesh/mesh.hpp"
#include "rays/levels.hpp"

namespace rsh {

void describe_hits(Recorder& recorder, const rsh_traverse_desc& desc,
                   const HitDescriptions& wanted) {
    if (!wanted.normals && !wanted.points && !wanted.geometry_ids) return;
    const rsh_geometry& geometry = desc.geometry;
    const auto rays = static_cast<cl_uint>(ray_count(desc.width, desc.height));
    const bool is_all = desc.query == RSH_QUERY_ALL;
    const cl_uint most = is_all ? static_cast<cl_uint>(desc.hit_capacity) : rays;
    const cl_mem offsets = is_all ? desc.hit_offsets : nullptr;
    recorder.launch(RSH_STAGE_OTHER, {"traverse/describe_hits", "rsh_describe_hits"},
                    recorder.stream_range(most), mesh_view_of(geometry), geometry.vertices,
                    geometry.indices, geometry.ranges, geometry.range_count, rays,
                    desc.list_count, offsets, most, desc.hits, wanted.normals, wanted.points,
                    wanted.geometry_ids);
}

}  // namespace rsh
