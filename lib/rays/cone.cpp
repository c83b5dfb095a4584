#include "rays/cone.hpp"

#include "rays/levels.hpp"
#include "rays/types.h"

namespace rsh {

ray_levels Cone::levels(cl_uint width, cl_uint height) const {
    return cone_levels(width, height);
}

size_t Cone::bytes(const ray_levels& levels) const {
    return sizeof(nodes_head) + levels.first_child_group[levels.count] * sizeof(cone_node4);
}

Layout Cone::scratch(const Context& context, const ray_levels&) const {
    return Layout(context.caps.alignment);
}

void Cone::build(Recorder& recorder, const rsh_build_desc& desc) const {
    const ray_levels shape = levels(desc.width, desc.height);
    const auto parents = [&shape](cl_uint level) {
        return size_t{shape.width[level + 1]} * shape.height[level + 1];
    };
    recorder.launch(RSH_STAGE_BUILD, {"programs/paper_faithful", "rsh_build_cones_rays"},
                    recorder.range(parents(0)), shape, desc.rays, desc.converging, desc.nodes);
    for (cl_uint level = 1; level < shape.count; ++level)
        recorder.launch(RSH_STAGE_BUILD, {"programs/paper_faithful", "rsh_build_cones_level"},
                        recorder.range(parents(level)), shape, level, desc.nodes);
}

}  // namespace rsh
