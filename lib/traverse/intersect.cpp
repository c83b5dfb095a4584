#include "traverse/intersect.hpp"

#include "mesh/mesh.hpp"
#include "rays/levels.hpp"

namespace rsh {

cl_uint occlusion_mask(const rsh_traverse_desc& desc) {
    return desc.query == RSH_QUERY_ANY ? cl_uint{1} << desc.occlusion_bit : 0;
}

void clear_hits(Recorder& recorder, const rsh_traverse_desc& desc, const char* program) {
    if (desc.query == RSH_QUERY_ANY) return;
    const cl_uint rays = static_cast<cl_uint>(ray_count(desc.width, desc.height));
    recorder.launch(RSH_STAGE_OTHER, {program, "rsh_clear_hits"}, recorder.stream_range(rays),
                    desc.rays, rays, desc.list_count, desc.hits);
}

void intersect(Recorder& recorder, const rsh_traverse_desc& desc, cl_mem pairs,
               cl_mem pair_count) {
    const rsh_geometry& geometry = desc.geometry;
    recorder.launch(RSH_STAGE_INTERSECT, {"programs/paper_faithful", "rsh_intersect"},
                    recorder.stream_range(), mesh_view_of(geometry), geometry.vertices,
                    geometry.indices, desc.rays, desc.skip, pairs, pair_count, desc.hits,
                    desc.occlusion, occlusion_mask(desc));
}

void resolve(Recorder& recorder, const rsh_traverse_desc& desc) {
    if (desc.query == RSH_QUERY_ANY) return;
    const rsh_geometry& geometry = desc.geometry;
    const cl_uint rays = static_cast<cl_uint>(ray_count(desc.width, desc.height));
    recorder.launch(RSH_STAGE_INTERSECT, {"programs/paper_faithful", "rsh_resolve"},
                    recorder.stream_range(rays), mesh_view_of(geometry), geometry.vertices,
                    geometry.indices, desc.rays, rays, desc.list_count, desc.hits);
}

}  // namespace rsh
