#include "bounds/box.hpp"

#include "bounds/levels.hpp"
#include "passes/mesh.hpp"

namespace rsh {
namespace {

constexpr cl_uint kBoxesPerGroup = 16;

cl_uint groups_of(cl_uint boxes) {
    return (boxes + kBoxesPerGroup - 1) / kBoxesPerGroup;
}

}  // namespace

Range serial_range(const Context& context, size_t items) {
    return {items, context.vector_width > 1 ? 1 : context.caps.group_size};
}

rsh_box_levels box_levels(cl_uint triangle_count) {
    rsh_box_levels levels = {};
    levels.boxes[0] = triangle_count;
    levels.count = 1;
    levels.group_count = groups_of(triangle_count);
    do {
        const cl_uint level = levels.count++;
        levels.boxes[level] = groups_of(levels.boxes[level - 1]);
        levels.first_group[level] = levels.group_count;
        levels.group_count += groups_of(levels.boxes[level]);
    } while (levels.boxes[levels.count - 1] > kBoxesPerGroup);
    return levels;
}

rsh_levels Box::levels(cl_uint width, cl_uint height) const {
    rsh_levels levels = ray_level(width, height);
    levels.fan = 4;
    add_level(levels);
    add_level(levels);
    return levels;
}

size_t Box::node_bytes(const rsh_levels& levels) const {
    return node_count(levels, 2) * sizeof(rsh_node_group);
}

size_t Box::scene_bytes(const rsh_geometry& geometry) const {
    return box_levels(geometry.triangle_count).group_count * sizeof(rsh_box_group);
}

void Box::bound(Recorder& recorder, const rsh_bound_desc& desc) const {
    const rsh_geometry& geometry = desc.geometry;
    const Context& context = recorder.context();
    const rsh_box_levels levels = box_levels(geometry.triangle_count);
    const cl_uint clusters = groups_of(geometry.triangle_count);
    recorder.launch(RSH_STAGE_BOUND, {"program_tiles", "rsh_bound_triangles"},
                    serial_range(context, groups_of(clusters)), mesh_of(geometry),
                    geometry.vertices, geometry.indices, levels, desc.bounds);
    for (cl_uint level = 2; level < levels.count; ++level)
        recorder.launch(RSH_STAGE_BOUND, {"program_tiles", "rsh_bound_groups"},
                        serial_range(context, groups_of(levels.boxes[level])), levels, level,
                        desc.bounds);
}

void Box::build(Recorder& recorder, const rsh_build_desc& desc) const {
    const rsh_levels shape = levels(desc.width, desc.height);
    recorder.launch(RSH_STAGE_BUILD, {"program_tiles", "rsh_build_blocks"},
                    serial_range(recorder.context(), node_count(shape, 2)), shape, desc.rays,
                    desc.converging, desc.nodes);
}

}  // namespace rsh
