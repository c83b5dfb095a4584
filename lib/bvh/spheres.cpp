#include "bvh/spheres.hpp"

#include "bvh/types.h"
#include "mesh/mesh.hpp"

namespace rsh {

size_t Spheres::bytes(const rsh_geometry& geometry) const {
    return sizeof(spheres_head) + size_t{geometry.triangle_count} * 16;
}

Layout Spheres::scratch(const Context& context, const rsh_geometry&, cl_uint) const {
    return Layout(context.caps.alignment);
}

void Spheres::bound(Recorder& recorder, const rsh_bound_desc& desc) const {
    const rsh_geometry& geometry = desc.geometry;
    recorder.launch(RSH_STAGE_BOUND, {"programs/paper_faithful", "rsh_spheres"},
                    recorder.range(geometry.triangle_count), mesh_view_of(geometry),
                    geometry.vertices, geometry.indices, desc.bounds);
}

}  // namespace rsh
