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

KernelName tiles_kernel(const char* kernel) {
    return {"program_tiles", kernel};
}

// How triangles are sorted (order_triangles.cl): by cells of 2^-bits of the scene, with so many
// work-items that have bins of their own.
struct Sorting {
    cl_uint bits, items;

    size_t bins() const { return size_t{items} * RSH_ORDER_BINS(bits); }
};

// Up to 32 triangles for each cell of space, most of which are empty; and no more bins than
// triangles, but for four work-items.
Sorting sorting_of(const Context& context, cl_uint triangles) {
    Sorting sorting = {4, 4};
    while (sorting.bits < 7 && triangles >> (3 * sorting.bits + 5)) ++sorting.bits;
    const cl_uint most = std::max(4u, triangles / RSH_ORDER_BINS(sorting.bits));
    sorting.items = std::min({context.caps.compute_units * 2, most, 64u});
    return sorting;
}

void order_triangles(Recorder& recorder, const rsh_geometry& geometry, cl_mem boxes,
                     const Scratch& scratch) {
    const cl_uint triangles = geometry.triangle_count;
    const Sorting sorting = sorting_of(recorder.context(), triangles);
    const Range items = {sorting.items, 1};
    const rsh_mesh mesh = mesh_of(geometry);
    const rsh_box_levels levels = box_levels(triangles);
    const cl_mem extents = scratch["extents"], bins = scratch["bins"], keys = scratch["keys"];
    recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_order_measure"), items, mesh,
                    geometry.vertices, geometry.indices, extents);
    recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_order_keys"), items, mesh,
                    geometry.vertices, geometry.indices, sorting.bits, extents, keys, bins);
    recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_order_scan"), {1, 1}, sorting.items,
                    sorting.bits, bins);
    recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_order_scatter"), items, levels,
                    sorting.bits, extents, keys, bins, boxes);
    recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_order_refine"),
                    {size_t{16} * sorting.items, 1}, levels, sorting.items, sorting.bits,
                    extents, keys, bins, scratch["sorted"], boxes);
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
    const Sorting sorting = sorting_of(context, geometry.triangle_count);
    Layout layout(context.caps.alignment);
    layout.add_array<rsh_scene_extent>("extents", sorting.items);
    layout.add_array<cl_uint>("bins", sorting.bins());
    layout.add_array<cl_uint>("keys", geometry.triangle_count);
    layout.add_array<cl_uint>("sorted", geometry.triangle_count);
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
