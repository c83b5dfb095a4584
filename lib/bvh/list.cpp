#include "bvh/scene_bounds.hpp"
#include "device/error.hpp"

namespace rsh {

// Each in a file of its name.
const SceneBounds& bvh16_bounds();
const SceneBounds& sphere_bounds();

const SceneBounds& bounds_for(cl_uint shape) {
    for (const SceneBounds* bounds : {&bvh16_bounds(), &sphere_bounds()})
        if (shape == bounds->shape()) return *bounds;
    throw Error(RSH_INVALID_VALUE, "shape: is ", shape, ", must be RSH_SHAPE_...");
}

void bound(Recorder& recorder, const rsh_bound_desc& desc) {
    bounds_for(desc.shape).bound(recorder, desc);
}

}  // namespace rsh
