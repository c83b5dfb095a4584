// bound.hpp - one shape of node: what encloses rays, and what it is tested against on the
// scene's side. All bounds leave the same hits; list.cpp knows which ones there are.
#pragma once

#include <vector>

#include "device/cl/recorder.hpp"
#include "device/layout.hpp"

namespace rsh {

class Bound {
public:
    virtual ~Bound() = default;
    virtual cl_uint id() const noexcept = 0;        // RSH_BOUND_...
    virtual const char* name() const noexcept = 0;  // command lines, logs, benchmarks
    virtual rsh_levels levels(cl_uint width, cl_uint height) const = 0;
    virtual size_t node_bytes(const rsh_levels& levels) const = 0;
    virtual size_t scene_bytes(const rsh_geometry& geometry) const = 0;
    virtual Layout bound_scratch(const Context& context, const rsh_geometry& geometry,
                                 cl_uint update) const = 0;  // RSH_UPDATE_...
    virtual Layout build_scratch(const Context& context, const rsh_levels& levels) const = 0;
    virtual void bound(Recorder& recorder, const rsh_bound_desc& desc) const = 0;  // the scene
    virtual void build(Recorder& recorder, const rsh_build_desc& desc) const = 0;  // the rays
};

const std::vector<const Bound*>& bounds();
const Bound& find_bound(cl_uint id);  // throws; RSH_BOUND_DEFAULT: box

}  // namespace rsh
