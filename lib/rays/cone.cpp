#include "rays/cone.hpp"

#include "mesh/mesh.hpp"
#include "rays/levels.hpp"
#include "rays/types.h"

namespace rsh {

rsh_levels Cone::levels(cl_uint width, cl_uint height) const {
    rsh_levels levels = ray_level(width, height);
    levels.branching = 2;
    cl_uint quads = 0;
    do {
        const cl_uint l = add_level(levels);
        levels.first_child_group[l] = quads;
        quads += levels.width[l + 1] * levels.height[l + 1];
    } while (levels.width[levels.count] > 1 || levels.height[levels.count] > 1);
    levels.first_child_group[levels.count] = quads;
    return levels;
}

size_t Cone::node_bytes(const rsh_levels& levels) const {
    return levels.first_child_group[levels.count] * sizeof(cone_node4);
}

size_t Cone::scene_bytes(const rsh_geometry& geometry) const {
    return size_t{geometry.triangle_count} * 16;
}

Layout Cone::bound_scratch(const Context& context, const rsh_geometry&, cl_uint) const {
    return Layout(context.caps.alignment);
}

Layout Cone::build_scratch(const Context& context, const rsh_levels&) const {
    return Layout(context.caps.alignment);
}

void Cone::bound(Recorder& recorder, const rsh_bound_desc& desc) const {
    const rsh_geometry& geometry = desc.geometry;
    recorder.launch(RSH_STAGE_BOUND, {"programs/paper_faithful", "rsh_spheres"},
                    recorder.range(geometry.triangle_count), mesh_view_of(geometry),
                    geometry.vertices, geometry.indices, desc.bounds);
}

void Cone::build(Recorder& recorder, const rsh_build_desc& desc) const {
    const rsh_levels shape = levels(desc.width, desc.height);
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
