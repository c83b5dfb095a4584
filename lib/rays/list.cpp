#include "device/error.hpp"
#include "rays/node_shape.hpp"

namespace rsh {

// Each in a file of its name.
const NodeShape& box_shape();
const NodeShape& cone_shape();

Choices<NodeShape> node_shapes() {
    static const NodeShape* const all[] = {&box_shape(), &cone_shape()};
    return all;
}

const NodeShape& find_shape(cl_uint id) {
    for (const NodeShape* shape : node_shapes())
        if (shape->id() == id) return *shape;
    throw Error(RSH_INVALID_VALUE, "shape: is ", id, ", must be RSH_SHAPE_...");
}

void build(Recorder& recorder, const rsh_build_desc& desc) {
    find_shape(desc.shape).build(recorder, desc);
}

}  // namespace rsh
