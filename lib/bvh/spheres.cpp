// spheres.cpp - a sphere around each triangle, no hierarchy: the scene's side of the paper's
// engine. kernels/bvh/spheres.cl.
#include "bvh/scene_bounds.hpp"
#include "bvh/types.h"
#include "mesh/mesh.hpp"

namespace rsh {
namespace {

class Spheres final : public SceneBounds {
public:
    cl_uint shape() const noexcept override { return RSH_SHAPE_CONE; }

    size_t bytes(const rsh_geometry& geometry) const override {
        return sizeof(spheres_head) + size_t{geometry.triangle_count} * 16;
    }

    size_t bytes_up_to(cl_uint triangles) const override {
        rsh_geometry geometry = {};
        geometry.triangle_count = triangles;
        return bytes(geometry);
    }

    Layout scratch(const Context& context, const rsh_geometry&, cl_uint) const override {
        return Layout(context.caps.alignment);
    }

    void bound(Recorder& recorder, const rsh_bound_desc& desc) const override {
        const rsh_geometry& geometry = desc.geometry;
        const cl_uint first = desc.mode == RSH_BOUND_REFIT ? geometry.still_triangles : 0;
        recorder.launch(RSH_STAGE_BOUND, {"programs/paper_faithful", "rsh_spheres"},
                        recorder.range(geometry.triangle_count - first), mesh_view_of(geometry),
                        geometry.vertices, geometry.indices, first, desc.bounds,
                        recorder.wrong_buffers());
    }
};

}  // namespace

const SceneBounds& sphere_bounds() {
    static const Spheres bounds;
    return bounds;
}

}  // namespace rsh
