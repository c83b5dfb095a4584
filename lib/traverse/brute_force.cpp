#include "traverse/brute_force.hpp"

#include "mesh/mesh.hpp"
#include "rays/levels.hpp"
#include "traverse/intersect.hpp"
#include "tuning.h"

namespace rsh {
namespace {}  // namespace

Layout BruteForce::scratch(const Context& context, const rsh_traverse_desc&, BoundsFrom) const {
    return Layout(context.caps.alignment);
}

void BruteForce::traverse(Recorder& recorder, const rsh_traverse_desc& desc) const {
    const rsh_geometry& geometry = desc.geometry;
    const cl_uint rays = static_cast<cl_uint>(ray_count(desc.width, desc.height));
    const size_t rays_per_item = size_t{RSH_VECTORS_PER_ITEM} * recorder.context().vector_width;
    recorder.launch(RSH_STAGE_INTERSECT, {"traverse/brute_force", "rsh_brute_force"},
                    recorder.serial_range((rays + rays_per_item - 1) / rays_per_item),
                    mesh_view_of(geometry), geometry.vertices, geometry.indices, desc.rays,
                    rays, desc.hits, desc.occlusion, occlusion_mask(desc));
}

}  // namespace rsh
