// cone_fitted.hpp - cones capped by spheres as in cone.hpp, each fitted to all its rays instead
// of to its children, 16 children to a node (rays/build_fitted_cones.cl); against spheres around the
// triangles (bvh/spheres.cl).
#pragma once

#include "rays/bound.hpp"

namespace rsh {

class ConeFitted final : public Bound {
public:
    cl_uint id() const noexcept override { return RSH_BOUND_CONE_FITTED; }
    const char* name() const noexcept override { return "cone_fitted"; }
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
