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
    const Answers answers = answers_of(desc);
    launch_hits(recorder, desc, RSH_STAGE_TEST,
                hit_kernel(desc, "programs/paper_faithful",
                           "traverse/paper_faithful/traverse_walk", "rsh_traverse_walk"),
                recorder.stream_range(), levels, level, streams.limit, mesh_view_of(geometry),
                geometry.vertices, geometry.indices, desc.rays, desc.skip, desc.bounds,
                desc.nodes, streams.pairs, streams.counts, answers.hits, answers.occlusion,
                answers.occlusion_bit);
}

}  // namespace rsh
