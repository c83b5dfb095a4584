#include "traverse/merge_hits.hpp"

#include "rays/levels.hpp"

namespace rsh {
namespace {

constexpr const char* kProgram = "traverse/merge_hits";

cl_uint rays_of(const rsh_traverse_desc& desc) {
    return static_cast<cl_uint>(ray_count(desc.width, desc.height));
}

}  // namespace

void shorten_rays(Recorder& recorder, const rsh_traverse_desc& desc, cl_mem shortened) {
    const cl_uint rays = rays_of(desc);
    recorder.launch(RSH_STAGE_OTHER, {kProgram, "rsh_shorten_rays"},
                    recorder.stream_range(rays), desc.rays, rays, desc.list_count, desc.hits,
                    shortened);
}

void merge_hits(Recorder& recorder, const rsh_traverse_desc& desc, cl_mem found) {
    const cl_uint rays = rays_of(desc);
    recorder.launch(RSH_STAGE_INTERSECT, {kProgram, "rsh_merge_hits"},
                    recorder.stream_range(rays), found, rays, desc.list_count,
                    desc.first_triangle, desc.continued, desc.hits);
}

}  // namespace rsh
