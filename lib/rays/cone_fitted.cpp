#include "rays/cone_fitted.hpp"

#include "mesh/mesh.hpp"
#include "rays/box.hpp"
#include "rays/levels.hpp"
#include "rays/types.h"
#include "traverse/paper/traverse_runs.hpp"

namespace rsh {
namespace {

KernelName kernel(const char* name) {
    return paper_kernel(RSH_BOUND_CONE_FITTED, name);
}

}  // namespace

rsh_levels ConeFitted::levels(cl_uint width, cl_uint height) const {
    return group_levels(width, height);
}

size_t ConeFitted::node_bytes(const rsh_levels& levels) const {
    return levels.first_quad[levels.count] * sizeof(rsh_cone_group);
}

size_t ConeFitted::scene_bytes(const rsh_geometry& geometry) const {
    return size_t{geometry.triangle_count} * 16;
}

Layout ConeFitted::bound_scratch(const Context& context, const rsh_geometry&, cl_uint) const {
    return Layout(context.caps.alignment);
}

Layout ConeFitted::build_scratch(const Context& context, const rsh_levels&) const {
    return Layout(context.caps.alignment);
}

void ConeFitted::bound(Recorder& recorder, const rsh_bound_desc& desc) const {
    const rsh_geometry& geometry = desc.geometry;
    recorder.launch(RSH_STAGE_BOUND, kernel("rsh_bound"),
                    recorder.range(geometry.triangle_count), mesh_of(geometry),
                    geometry.vertices, geometry.indices, desc.bounds);
}

void ConeFitted::build(Recorder& recorder, const rsh_build_desc& desc) const {
    const rsh_levels shape = levels(desc.width, desc.height);
    const Range tiles = recorder.serial_range(node_count(shape, 2));
    recorder.launch(RSH_STAGE_BUILD, kernel("rsh_fit_tiles"), tiles, shape, desc.rays,
                    desc.converging, desc.nodes);
    for (cl_uint level = 3; level < shape.count; ++level) {
        recorder.launch(RSH_STAGE_BUILD, kernel("rsh_guess_level"),
                        recorder.serial_range(node_count(shape, level + 1)), shape, level,
                        desc.nodes);
        recorder.launch(RSH_STAGE_BUILD, kernel("rsh_measure_level"), tiles, shape, level,
                        desc.rays, desc.converging, desc.nodes);
    }
}

}  // namespace rsh
