// cone.hpp - the node of Roger, Assarsson and Holzschuch 2007: a cone capped by a sphere, four
// children each, up to a root (rays/build_cones.cl); against spheres around the triangles (bvh/spheres.cl).
#pragma once

#include "rays/bound.hpp"

namespace rsh {

class Cone final : public Bound {
public:
    cl_uint id() const noexcept override { return RSH_BOUND_CONE; }
    const char* name() const noexcept override { return "cone"; }
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
