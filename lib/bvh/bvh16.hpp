// bvh16.hpp - a bounding volume hierarchy of 16 children to a node and up to 16 triangles to a
// leaf, made anew or refitted, in linear time: kernels/bvh/leaves.cl and its neighbours.
#pragma once

#include "bvh/scene_bounds.hpp"

namespace rsh {

class Bvh16 final : public SceneBounds {
public:
    cl_uint shape() const noexcept override { return RSH_SHAPE_BOX; }
    size_t bytes(const rsh_geometry& geometry) const override;
    Layout scratch(const Context& context, const rsh_geometry& geometry,
                   cl_uint mode) const override;
    void bound(Recorder& recorder, const rsh_bound_desc& desc) const override;
};

}  // namespace rsh
