#include "bounds/box.hpp"

#include <algorithm>

#include "bounds/levels.hpp"
#include "cl/scratch.hpp"
#include "passes/mesh.hpp"

namespace rsh {
namespace {

constexpr cl_uint kBoxesPerGroup = 16;

cl_uint groups_of(cl_uint boxes) {
    return (boxes + kBoxesPerGroup - 1) / kBoxesPerGroup;
}

// Work-items of the sort, each with counts of its own.
Range order_range(const Context& context) {
    const size_t items = std::min<size_t>(context.caps.compute_units * 2, 64);
    return {items, 1};
}

KernelName tiles_kernel(const char* kernel) {
    return {"program_tiles", kernel};
}

// Where each triangle goes, in two passes of a counting sort (order_triangles.cl).
void order_triangles(Recorder& recorder, const rsh_geometry& geometry, cl_mem boxes,
                     const Scratch& scratch) {
    const Range items = order_range(recorder.context());
    const cl_uint item_count = static_cast<cl_uint>(items.items);
    const rsh_mesh mesh = mesh_of(geometry);
    const cl_mem extents = scratch["extents"], bins = scratch["bins"], keys = scratch["keys"],
                 half_sorted = scratch["half sorted"];
    recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_order_measure"), items, mesh,
                    geometry.vertices, geometry.indices, extents);
    recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_order_keys"), items, mesh,
                    geometry.vertices, geometry.indices, extents, keys, bins);
    recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_order_scan"), {1, 1}, item_count, bins);
    recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_order_scatter_low"), items,
                    geometry.triangle_count, keys, bins, half_sorted);
    recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_order_count_high"), items,
                    geometry.triangle_count, half_sorted, bins);
    recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_order_scan"), {1, 1}, item_count, bins);
    recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_order_scatter_high"), items,
                    box_levels(geometry.triangle_count), half_sorted, bins, boxes);
}

}  // namespace

rsh_box_levels box_levels(cl_uint triangle_count) {
    rsh_box_levels levels = {};
    levels.boxes[0] = triangle_count;
    levels.count = 1;
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
    const rsh_box_levels levels = box_levels(geometry.triangle_count);
    const size_t words = size_t{levels.boxes[0]} + groups_of(levels.boxes[1]);
    return levels.boxes[1] * sizeof(rsh_cluster) + levels.group_count * sizeof(rsh_box_group) +
           words * sizeof(cl_uint);
}

Layout Box::bound_scratch(const Context& context, const rsh_geometry& geometry) const {
    const size_t items = order_range(context).items;
    Layout layout(context.caps.alignment);
    layout.add_array<rsh_scene_extent>("extents", items);
    layout.add_array<cl_uint>("bins", items * RSH_ORDER_BINS);
    layout.add_array<cl_uint>("keys", geometry.triangle_count);
    layout.add_array<cl_uint>("half sorted", size_t{2} * geometry.triangle_count);
    return layout;
}

void Box::bound(Recorder& recorder, const rsh_bound_desc& desc) const {
    const rsh_geometry& geometry = desc.geometry;
    if (geometry.triangle_count == 0) return;
    const Scratch scratch(recorder, bound_scratch(recorder.context(), geometry), desc.scratch);
    const rsh_box_levels levels = box_levels(geometry.triangle_count);
    order_triangles(recorder, geometry, desc.bounds, scratch);
    recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_bound_clusters"),
                    recorder.serial_range(groups_of(levels.boxes[1])), mesh_of(geometry),
                    geometry.vertices, geometry.indices, levels, desc.bounds);
    for (cl_uint level = 2; level < levels.count; ++level)
        recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_bound_groups"),
                        recorder.serial_range(groups_of(levels.boxes[level])), levels, level,
                        desc.bounds);
}

void Box::build(Recorder& recorder, const rsh_build_desc& desc) const {
    const rsh_levels shape = levels(desc.width, desc.height);
    recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_build_blocks"),
                    recorder.serial_range(node_count(shape, 2)), shape, desc.rays,
                    desc.converging, desc.nodes);
}

}  // namespace rsh
