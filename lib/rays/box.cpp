#include "rays/box.hpp"

#include <algorithm>

#include "bvh/types.h"
#include "device/cl/scratch.hpp"
#include "mesh/mesh.hpp"
#include "order/sort.hpp"
#include "rays/levels.hpp"
#include "rays/types.h"

namespace rsh {
namespace {

// Cells of 2^-bits of the scene that triangles are sorted by: up to 32 triangles for each cell
// of space, most of which are empty.
cl_uint cell_bits(cl_uint triangles) {
    cl_uint bits = 4;
    while (bits < 7 && triangles >> (3 * bits + 5)) ++bits;
    return bits;
}

Sort sort_of_triangles(const Context& context, cl_uint triangles) {
    return {triangles, RSH_ORDER_BINS(cell_bits(triangles)), context.caps.compute_units};
}

Sort sort_of_rays(const Context& context, const rsh_levels& list) {
    return {list.width[0], RSH_RAY_BINS, context.caps.compute_units};
}

// The scene's side: triangles in their order, then boxes, level by level.
class SceneBvh {
public:
    SceneBvh(Recorder& recorder, const rsh_bound_desc& desc, const Scratch& scratch)
        : recorder_(recorder), desc_(desc), scratch_(scratch) {}

    // bvh/order.cl.
    void order() const {
        if (is_refit_) measure_quality(scratch_["quality"], 0, false);
        launch("rsh_order_measure", sort_.items(), layout_, is_refit_, scratch_["quality"],
               desc_.bounds, scratch_["samples"], scratch_["sorting"]);
        launch("rsh_order_keys", sort_.items(), desc_.bounds, cell_bits(mesh_.triangle_count),
               scratch_["samples"], scratch_["sorting"], scratch_["keys"], scratch_["bins"]);
        sort_.run(recorder_, RSH_STAGE_BOUND, scratch_, desc_.bounds, RSH_ORDER_AT(layout_));
        measure_quality(desc_.bounds, RSH_QUALITY_AT(layout_), true);
    }

    // bvh/leaves.cl: where the order is a new one.
    void make() const {
        const cl_uint sample_count = sort_.items().items,
                      is_quality = desc_.update != RSH_UPDATE_NONE;
        launch("rsh_leaves", parts(), layout_, scratch_["sorting"], sample_count,
               scratch_["samples"], is_quality, desc_.bounds, scratch_["child boxes"],
               scratch_["tree"]);
        if (!is_quality) {
            launch_above("rsh_nodes_from_ranges", {1, 1}, scratch_["sorting"], sample_count,
                         scratch_["samples"], desc_.bounds, scratch_["child boxes"]);
            return;
        }
        launch_above("rsh_nodes_tree_top", {1, 1}, scratch_["sorting"], sample_count,
                     scratch_["samples"], desc_.bounds, scratch_["child boxes"],
                     scratch_["tree"]);
        launch_above("rsh_nodes_tree_parts", parts(), scratch_["sorting"], desc_.bounds,
                     scratch_["child boxes"], scratch_["tree"]);
    }

    // bvh/refit.cl: where the order was kept.
    void refit() const {
        if (!is_refit_) return;
        launch("rsh_refit", parts(), layout_, scratch_["sorting"], desc_.bounds,
               scratch_["child boxes"]);
        launch_above("rsh_refit_upper_nodes", {1, 1}, scratch_["sorting"], desc_.bounds,
                     scratch_["child boxes"]);
    }

private:
    void measure_quality(cl_mem quality, cl_ulong first, bool is_record) const {
        launch("rsh_order_quality", {RSH_QUALITY_SAMPLES, 1}, layout_, cl_uint{is_record},
               scratch_["sorting"], desc_.bounds, quality, first);
    }

    Range parts() const { return recorder_.serial_range(layout_.parts); }

    template <class... Arguments>
    void launch(const char* kernel, Range range, const Arguments&... arguments) const {
        recorder_.launch(RSH_STAGE_BOUND, tiles_kernel(kernel), range, mesh_,
                         desc_.geometry.vertices, desc_.geometry.indices, arguments...);
    }

    // What does not look at triangles.
    template <class... Arguments>
    void launch_above(const char* kernel, Range range, const Arguments&... arguments) const {
        recorder_.launch(RSH_STAGE_BOUND, tiles_kernel(kernel), range, layout_, arguments...);
    }

    Recorder& recorder_;
    const rsh_bound_desc& desc_;
    const Scratch& scratch_;
    const cl_uint is_refit_ = desc_.update == RSH_UPDATE_NEXT;
    const mesh_view mesh_ = mesh_view_of(desc_.geometry);
    const bvh_layout layout_ = bvh_layout_of(mesh_.triangle_count);
    const Sort sort_ = sort_of_triangles(recorder_.context(), mesh_.triangle_count);
};

// rays/sort_rays.cl: behind the groups of a list's blocks.
void order_rays(Recorder& recorder, const rsh_build_desc& desc, const rsh_levels& list,
                const Scratch& scratch) {
    const Sort sort = sort_of_rays(recorder.context(), list);
    const cl_uint rays = list.width[0];
    recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_sort_rays_measure"), sort.items(),
                    desc.rays, rays, scratch["samples"]);
    recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_sort_rays_sample"), sort.items(),
                    desc.rays, rays, scratch["samples"], scratch["sampled"]);
    recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_sort_rays_keys"), sort.items(),
                    desc.rays, rays, scratch["samples"], scratch["sampled"], scratch["sorting"],
                    scratch["keys"], scratch["bins"]);
    sort.run(recorder, RSH_STAGE_BUILD, scratch, desc.nodes,
             RSH_RAY_ORDER_AT(node_count(list, 2)));
    recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_build_boxes_order"), {1, 1}, list,
                    scratch["sorting"], desc.nodes);
}

}  // namespace

rsh_levels Box::levels(cl_uint width, cl_uint height) const {
    rsh_levels levels = ray_level(width, height);
    levels.branching = 4;
    add_level(levels);
    add_level(levels);
    return levels;
}

size_t Box::node_bytes(const rsh_levels& levels) const {
    const size_t order = levels.is_list ? size_t{levels.width[0]} + 1 : 0;
    return node_count(levels, 2) * sizeof(box_node16) + order * sizeof(cl_uint);
}

size_t Box::scene_bytes(const rsh_geometry& geometry) const {
    const bvh_layout bvh = bvh_layout_of(geometry.triangle_count);
    return RSH_BVH_WORDS(bvh) * sizeof(cl_uint);
}

Layout Box::bound_scratch(const Context& context, const rsh_geometry& geometry,
                          cl_uint update) const {
    Layout layout(context.caps.alignment);
    layout.add_array<refit_quality>("quality", RSH_QUALITY_SAMPLES);
    sort_of_triangles(context, geometry.triangle_count).reserve(layout);
    const bvh_layout bvh = bvh_layout_of(geometry.triangle_count);
    layout.reuse_from(Sort::kOnlyWhileSorting);
    layout.add_array<child_box>("child boxes", RSH_LEAVES(bvh) + RSH_NODES(bvh));
    if (update != RSH_UPDATE_NONE) layout.add_array<cl_float>("tree", RSH_TREE_WORDS(bvh));
    return layout;
}

Layout Box::build_scratch(const Context& context, const rsh_levels& levels) const {
    Layout layout(context.caps.alignment);
    if (!levels.is_list) return layout;
    const Sort sort = sort_of_rays(context, levels);
    layout.add_array<cl_uint>("sampled", 2 * sort.items().items);
    sort.reserve(layout);
    return layout;
}

void Box::bound(Recorder& recorder, const rsh_bound_desc& desc) const {
    const rsh_geometry& geometry = desc.geometry;
    if (geometry.triangle_count == 0) {
        recorder.fill(RSH_STAGE_BOUND, desc.bounds, 0, sizeof(bvh_head));
        return;
    }
    const Scratch scratch(recorder, bound_scratch(recorder.context(), geometry, desc.update),
                          desc.scratch);
    const SceneBvh bvh(recorder, desc, scratch);
    bvh.order();
    bvh.make();
    bvh.refit();
}

void Box::build(Recorder& recorder, const rsh_build_desc& desc) const {
    const rsh_levels shape = levels(desc.width, desc.height);
    const Scratch scratch(recorder, build_scratch(recorder.context(), shape), desc.scratch);
    if (shape.is_list) order_rays(recorder, desc, shape, scratch);
    recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_build_boxes"),
                    recorder.serial_range(node_count(shape, 2)), shape, desc.rays,
                    desc.converging, desc.nodes);
}

}  // namespace rsh
