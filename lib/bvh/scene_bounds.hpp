// scene_bounds.hpp - what the triangles are bounded by, for one shape of node over the rays:
// all that a traversal needs on the scene's side. list.cpp knows which ones there are.
#pragma once

#include "device/cl/recorder.hpp"
#include "device/layout.hpp"

namespace rsh {

class SceneBounds {
public:
    virtual ~SceneBounds() = default;
    virtual cl_uint shape() const noexcept = 0;  // RSH_SHAPE_... that nodes must have
    virtual size_t bytes(const rsh_geometry& geometry) const = 0;
    // Of that many triangles, or of fewer.
    virtual size_t bytes_up_to(cl_uint triangles) const = 0;
    virtual Layout scratch(const Context& context, const rsh_geometry& geometry,
                           cl_uint mode) const = 0;  // RSH_SHAPE_...
    virtual void bound(Recorder& recorder, const rsh_bound_desc& desc) const = 0;
};

const SceneBounds& bounds_for(cl_uint shape);  // throws

// Bounds the triangles.
void bound(Recorder& recorder, const rsh_bound_desc& desc);

}  // namespace rsh
