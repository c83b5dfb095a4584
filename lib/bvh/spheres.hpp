// spheres.hpp - a sphere around each triangle, no hierarchy: the scene's side of the paper's
// engine. kernels/bvh/spheres.cl.
#pragma once

#include "bvh/scene_bounds.hpp"

namespace rsh {

class Spheres final : public SceneBounds {
public:
    cl_uint shape() const noexcept override { return RSH_SHAPE_CONE; }
    size_t bytes(const rsh_geometry& geometry) const override;
    Layout scratch(const Context& context, const rsh_geometry& geometry,
                   cl_uint mode) const override;
    void bound(Recorder& recorder, const rsh_bound_desc& desc) const override;
};

}  // namespace rsh
