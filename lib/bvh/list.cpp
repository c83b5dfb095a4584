#include "bvh/bvh16.hpp"
#include "bvh/spheres.hpp"
#include "device/error.hpp"

namespace rsh {

// The first one is the default.
const SceneBounds& bounds_for(cl_uint shape) {
    static const Bvh16 bvh16;
    static const Spheres spheres;
    for (const SceneBounds* bounds :
         {static_cast<const SceneBounds*>(&bvh16), static_cast<const SceneBounds*>(&spheres)})
        if (shape == bounds->shape() || shape == RSH_SHAPE_DEFAULT) return *bounds;
    throw Error(RSH_INVALID_VALUE,
                "shape: is " + std::to_string(shape) + ", must be RSH_SHAPE_...");
}

void bound(Recorder& recorder, const rsh_bound_desc& desc) {
    bounds_for(desc.shape).bound(recorder, desc);
}

}  // namespace rsh
