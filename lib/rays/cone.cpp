// cone.cpp - the node of Roger, Assarsson and Holzschuch 2007: a cone capped by a sphere, four
// children each, up to a root, in kernels/rays/build_cones.cl; against spheres around the
// triangles.
#include "rays/levels.hpp"
#include "rays/node_shape.hpp"
#include "rays/types.h"

namespace rsh {
namespace {

class Cone final : public NodeShape {
public:
    cl_uint id() const noexcept override { return RSH_SHAPE_CONE; }
    const char* name() const noexcept override { return "cone"; }

    ray_levels levels(cl_uint width, cl_uint height) const override {
        return cone_levels(width, height);
    }

    size_t bytes(const ray_levels& levels) const override {
        return sizeof(nodes_head) + levels.first_child_group[levels.count] * sizeof(cone_node4);
    }

    Layout scratch(const Context& context, const ray_levels&) const override {
        return Layout(context.caps.alignment);
    }

    void build(Recorder& recorder, const rsh_build_desc& desc) const override {
        const ray_levels shape = levels(desc.width, desc.height);
        const auto parents = [&shape](cl_uint level) {
            return size_t{shape.width[level + 1]} * shape.height[level + 1];
        };
        recorder.launch(RSH_STAGE_BUILD, {"programs/paper_faithful", "rsh_build_cones_rays"},
                        recorder.stream_range(parents(0)), shape, desc.list_count, desc.rays,
                        desc.converging, desc.nodes);
        for (cl_uint level = 1; level < shape.count; ++level)
            recorder.launch(RSH_STAGE_BUILD,
                            {"programs/paper_faithful", "rsh_build_cones_level"},
                            recorder.stream_range(parents(level)), shape, desc.list_count,
                            level, desc.nodes);
    }
};

}  // namespace

const NodeShape& cone_shape() {
    static const Cone shape;
    return shape;
}

}  // namespace rsh
