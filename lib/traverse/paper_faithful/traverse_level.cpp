#include "traverse/paper_faithful/traverse_level.hpp"

#include "mesh/mesh.hpp"
#include "traverse/intersect.hpp"

namespace rsh {

void test_level(Recorder& recorder, const rsh_traverse_desc& desc, const ray_levels& levels,
                cl_uint level, const PairStreams& streams, const Batch& batch) {
    recorder.launch(RSH_STAGE_TEST, {"programs/paper_faithful", "rsh_traverse_level"},
                    recorder.stream_range(), levels, desc.list_count, level, streams.limit,
                    batch.first_triangle, batch.triangle_count, desc.geometry.triangle_count,
                    desc.bounds, desc.nodes, streams.pairs, streams.counts,
                    streams.tested_pairs, streams.tested_count, recorder.wrong_buffers());
}

void walk_level(Recorder& recorder, const rsh_traverse_desc& desc, const ray_levels& levels,
                cl_uint level, const PairStreams& streams) {
    const rsh_geometry& geometry = desc.geometry;
    recorder.launch(RSH_STAGE_TEST, {"programs/paper_faithful", "rsh_traverse_walk"},
                    recorder.stream_range(), levels, level, streams.limit,
                    mesh_view_of(geometry), geometry.vertices, geometry.indices, desc.rays,
                    desc.skip, desc.bounds, desc.nodes, streams.pairs, streams.counts,
                    desc.hits, desc.occlusion, occlusion_mask(desc));
}

}  // namespace rsh
