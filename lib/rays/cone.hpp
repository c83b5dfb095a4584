// cone.hpp - the node of Roger, Assarsson and Holzschuch 2007: a cone capped by a sphere, four
// children each, up to a root, in kernels/rays/build_cones.cl; against spheres around the
// triangles.
#pragma once

#include "rays/node_shape.hpp"

namespace rsh {

class Cone final : public NodeShape {
public:
    cl_uint id() const noexcept override { return RSH_SHAPE_CONE; }
    const char* name() const noexcept override { return "cone"; }
    ray_levels levels(cl_uint width, cl_uint height) const override;
    size_t bytes(const ray_levels& levels) const override;
    Layout scratch(const Context& context, const ray_levels& levels) const override;
    void build(Recorder& recorder, const rsh_build_desc& desc) const override;
};

}  // namespace rsh
