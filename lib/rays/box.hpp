// box.hpp - a box of origins and a box of directions around 16 rays, 16 such blocks to a tile
// (rays/build_boxes.cl); against boxes around leaves of up to 16 triangles, and around nodes of
// up to 16 of these, and so on (bvh/leaves.cl).
#pragma once

#include "bvh/layout.hpp"
#include "rays/bound.hpp"

namespace rsh {

class Box final : public Bound {
public:
    cl_uint id() const noexcept override { return RSH_BOUND_BOX; }
    const char* name() const noexcept override { return "box"; }
    rsh_levels levels(cl_uint width, cl_uint height) const override;
    size_t node_bytes(const rsh_levels& levels) const override;
    size_t scene_bytes(const rsh_geometry& geometry) const override;
    Layout bound_scratch(const Context& context, const rsh_geometry& geometry,
                         cl_uint update) const override;
    Layout build_scratch(const Context& context, const rsh_levels& levels) const override;
    void bound(Recorder& recorder, const rsh_bound_desc& desc) const override;
    void build(Recorder& recorder, const rsh_build_desc& desc) const override;
};

}  // namespace rsh
