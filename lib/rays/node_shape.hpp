// node_shape.hpp - one shape of node: what encloses rays in the hierarchy over them. All shapes
// leave the same hits; list.cpp knows which ones there are.
#pragma once

#include "device/choices.hpp"
#include "device/cl/recorder.hpp"
#include "device/layout.hpp"
#include "rays/types.h"

namespace rsh {

class NodeShape {
public:
    virtual ~NodeShape() = default;
    virtual cl_uint id() const noexcept = 0;        // RSH_SHAPE_...
    virtual const char* name() const noexcept = 0;  // command lines, logs, benchmarks
    virtual ray_levels levels(cl_uint width, cl_uint height) const = 0;
    virtual size_t bytes(const ray_levels& levels) const = 0;
    virtual Layout scratch(const Context& context, const ray_levels& levels) const = 0;
    virtual void build(Recorder& recorder, const rsh_build_desc& desc) const = 0;
};

Choices<NodeShape> node_shapes();
const NodeShape& find_shape(cl_uint id);  // throws

// Builds the hierarchy over the rays.
void build(Recorder& recorder, const rsh_build_desc& desc);

}  // namespace rsh
