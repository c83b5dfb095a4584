#include "passes/intersect.hpp"

#include "passes/build.hpp"
#include "passes/mesh.hpp"

namespace rsh {

std::string query_options(const rsh_traverse_desc& desc) {
    return desc.query == RSH_QUERY_ANY ? "-D RSH_ANY=1" : "-D RSH_ANY=0";
}

void clear_hits(Recorder& recorder, const rsh_traverse_desc& desc) {
    if (desc.query == RSH_QUERY_ANY) return;
    const cl_ulong rays = ray_count(levels_of(desc.width, desc.height));
    recorder.fill(RSH_STAGE_OTHER, desc.hits, RSH_NO_HIT, rays * sizeof(rsh_hit));
}

void intersect(Recorder& recorder, const rsh_traverse_desc& desc, cl_mem pairs,
               cl_mem pair_count) {
    const rsh_geometry& geometry = desc.geometry;
    recorder.launch(RSH_STAGE_INTERSECT, {"intersect", "rsh_intersect", query_options(desc)},
                    recorder.stream_range(), mesh_of(geometry), geometry.vertices,
                    geometry.indices, desc.rays, pairs, pair_count, desc.hits, desc.occlusion,
                    cl_uint{1} << desc.occlusion_bit);
}

void resolve(Recorder& recorder, const rsh_traverse_desc& desc) {
    if (desc.query == RSH_QUERY_ANY) return;
    const rsh_geometry& geometry = desc.geometry;
    const cl_uint rays = static_cast<cl_uint>(ray_count(levels_of(desc.width, desc.height)));
    recorder.launch(RSH_STAGE_INTERSECT, {"resolve", "rsh_resolve"}, recorder.range(rays),
                    mesh_of(geometry), geometry.vertices, geometry.indices, desc.rays, rays,
                    desc.hits);
}

}  // namespace rsh
