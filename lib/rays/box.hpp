// box.hpp - a box of origins and a box of directions around 16 rays, 16 such blocks to a tile,
// in kernels/rays/build_boxes.cl; against the BVH16 of the scene.
#pragma once

#include "rays/node_shape.hpp"

namespace rsh {

class Box final : public NodeShape {
public:
    cl_uint id() const noexcept override { return RSH_SHAPE_BOX; }
    const char* name() const noexcept override { return "box"; }
    ray_levels levels(cl_uint width, cl_uint height) const override;
    size_t bytes(const ray_levels& levels) const override;
    Layout scratch(const Context& context, const ray_levels& levels) const override;
    void build(Recorder& recorder, const rsh_build_desc& desc) const override;
};

}  // namespace rsh
