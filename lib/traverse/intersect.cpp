#include "traverse/intersect.hpp"

#include "mesh/mesh.hpp"
#include "rays/levels.hpp"

namespace rsh {

static_assert(RSH_CULL_BACK == RSH_CULLED_BACK && RSH_CULL_FRONT == RSH_CULLED_FRONT,
              "kernels and callers name the same sides");

Answers answers_of(const rsh_traverse_desc& desc) {
    switch (desc.query) {
        case RSH_QUERY_ANY:
            return {desc.hits, desc.occlusion, cl_uint{1} << desc.occlusion_bit};
        case RSH_QUERY_COUNT:
            return {nullptr, desc.hit_counts, 0};
        case RSH_QUERY_ALL:
            return {desc.hits, desc.hit_counts, static_cast<cl_uint>(desc.hit_capacity)};
        default:
            return {desc.hits, desc.occlusion, 0};
    }
}

KernelName hit_kernel(const rsh_traverse_desc& desc, const char* program, const char* file,
                      const char* kernel) {
    const bool is_own = wants_all_hits(desc.query) || wants_filter(desc) || is_batch(desc);
    return {
        is_own ? file : program, kernel,
        std::string(all_hits_option(desc.query)) + filter_option(desc) + batch_option(desc)};
}

void clear_hits(Recorder& recorder, const rsh_traverse_desc& desc, const char* program) {
    if (desc.query == RSH_QUERY_ANY) return;
    const cl_uint rays = static_cast<cl_uint>(ray_count(desc.width, desc.height));
    if (wants_all_hits(desc.query)) {
        recorder.launch(RSH_STAGE_OTHER, {"traverse/clear_hits", "rsh_clear_hit_counts"},
                        recorder.stream_range(rays), rays, desc.list_count, desc.hit_counts);
        return;
    }
    recorder.launch(RSH_STAGE_OTHER, {program, "rsh_clear_hits"}, recorder.stream_range(rays),
                    desc.rays, rays, desc.list_count, desc.hits);
}

void intersect(Recorder& recorder, const rsh_traverse_desc& desc, cl_mem pairs,
               cl_mem pair_count) {
    const rsh_geometry& geometry = desc.geometry;
    const Answers answers = answers_of(desc);
    launch_hits(recorder, desc, RSH_STAGE_INTERSECT,
                hit_kernel(desc, "programs/paper_faithful", "traverse/paper_faithful/intersect",
                           "rsh_intersect"),
                recorder.stream_range(), mesh_view_of(geometry), geometry.vertices,
                geometry.indices, desc.rays, desc.skip, pairs, pair_count, answers.hits,
                answers.occlusion, answers.occlusion_bit);
}

void resolve(Recorder& recorder, const rsh_traverse_desc& desc) {
    if (desc.query != RSH_QUERY_CLOSEST) return;
    const rsh_geometry& geometry = desc.geometry;
    const cl_uint rays = static_cast<cl_uint>(ray_count(desc.width, desc.height));
    recorder.launch(RSH_STAGE_INTERSECT, {"programs/paper_faithful", "rsh_resolve"},
                    recorder.stream_range(rays), mesh_view_of(geometry), geometry.vertices,
                    geometry.indices, desc.rays, rays, desc.list_count, desc.hits);
}

}  // namespace rsh
