// bvh16.cpp - a bounding volume hierarchy of 16 children to a node and up to 16 triangles to a
// leaf, made anew or refitted, in linear time: kernels/bvh/leaves.cl and its neighbours.
#include <algorithm>
#include "bvh/scene_bounds.hpp"

#include "bvh/layout.hpp"
#include "device/cl/scratch.hpp"
#include "mesh/mesh.hpp"
#include "order/sort.hpp"

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

Layout scratch_of_tree(const Context& context, const bvh_layout& tree, cl_uint mode) {
    Layout layout(context.caps.alignment);
    if (tree.triangles == 0) return layout;
    layout.add_array<refit_quality>("quality", RSH_QUALITY_SAMPLES);
    sort_of_triangles(context, tree.triangles).reserve(layout);
    layout.reuse_from(Sort::kOnlyWhileSorting);
    layout.add_array<child_box>("child boxes", tree.whole.leaves + tree.whole.nodes);
    if (mode != RSH_BOUND_FAST) layout.add_array<cl_float>("tree", RSH_TREE_WORDS(tree));
    return layout;
}

// One of the scene's trees: its triangles in their order, then boxes, level by level.
class TreeOfScene {
public:
    TreeOfScene(Recorder& recorder, const rsh_bound_desc& desc, const bvh_layout& layout,
                cl_mem scratch)
        : recorder_(recorder),
          desc_(desc),
          layout_(layout),
          scratch_(recorder, scratch_of_tree(recorder.context(), layout, desc.mode), scratch) {}

    // bvh/order.cl.
    void order() const {
        const Range samples = {RSH_QUALITY_SAMPLES, 1};
        if (is_refit_) order_pass(RSH_QUALITY_PASS, samples);
        order_pass(RSH_SAMPLE_PASS, sort_.items());
        order_pass(RSH_KEYS_PASS, sort_.items());
        sort_.run(recorder_, RSH_STAGE_BOUND, scratch_, desc_.bounds, RSH_ORDER_AT(layout_));
        order_pass(RSH_RECORD_PASS, samples);
    }

    // bvh/leaves.cl: where the order is a new one.
    void make() const {
        const cl_uint sample_count = sort_.items().items,
                      is_quality = desc_.mode != RSH_BOUND_FAST;
        launch("rsh_leaves", parts(), layout_, scratch_["sorting"], sample_count,
               scratch_["samples"], is_quality, desc_.bounds, scratch_["child boxes"]);
        if (!is_quality) {
            launch_above("rsh_nodes_from_ranges", {1, 1}, scratch_["sorting"], sample_count,
                         scratch_["samples"], desc_.bounds, scratch_["child boxes"]);
            return;
        }
        for (const cl_uint pass : {RSH_GROW_PASS, RSH_TOP_PASS, RSH_NODES_PASS})
            launch_above("rsh_nodes_tree", pass == RSH_TOP_PASS ? Range{1, 1} : parts(),
                         scratch_["sorting"], sample_count, scratch_["samples"], pass,
                         desc_.bounds, scratch_["child boxes"], scratch_["tree"]);
    }

    // bvh/refit.cl: where the order was kept. Bounds that are made to be kept will need it.
    void refit() const {
        constexpr const char *kParts = "rsh_refit", *kAbove = "rsh_refit_upper_nodes";
        if (desc_.mode == RSH_BOUND_QUALITY)
            for (const char* kernel : {kParts, kAbove}) recorder_.expect(tiles_kernel(kernel));
        if (!is_refit_) return;
        launch(kParts, parts(), layout_, scratch_["sorting"], desc_.bounds,
               scratch_["child boxes"]);
        launch_above(kAbove, {1, 1}, scratch_["sorting"], desc_.bounds,
                     scratch_["child boxes"]);
    }

private:
    void order_pass(cl_uint pass, Range range) const {
        launch("rsh_order", range, layout_, pass, is_refit_, cell_bits(layout_.triangles),
               scratch_["quality"], desc_.bounds, scratch_["samples"], scratch_["sorting"],
               scratch_["keys"], scratch_["bins"], recorder_.wrong_buffers());
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
    const bvh_layout layout_;
    const Scratch scratch_;
    const cl_uint is_refit_ = desc_.mode == RSH_BOUND_REFIT;
    const mesh_view mesh_ =
        mesh_view_of(desc_.geometry, RSH_FIRST_TRIANGLE(layout_), layout_.triangles);
    const Sort sort_ = sort_of_triangles(recorder_.context(), layout_.triangles);
};

class Bvh16 final : public SceneBounds {
public:
    cl_uint shape() const noexcept override { return RSH_SHAPE_BOX; }

    size_t bytes(const rsh_geometry& geometry) const override {
        return bvh_words(bvh_layouts_of(geometry)) * sizeof(cl_uint);
    }

    size_t bytes_up_to(cl_uint triangles) const override {
        return most_bytes_up_to(triangles, [](cl_uint count) {
            rsh_geometry geometry = {};
            geometry.triangle_count = count;
            return bvh_words(bvh_layouts_of(geometry)) * sizeof(cl_uint);
        });
    }

    // The trees are made one after the other, in the same memory.
    Layout scratch(const Context& context, const rsh_geometry& geometry,
                   cl_uint mode) const override {
        size_t bytes = 0;
        for (const bvh_layout& tree : bvh_layouts_of(geometry))
            bytes = std::max(bytes, scratch_of_tree(context, tree, mode).bytes());
        Layout layout(context.caps.alignment);
        layout.add("tree", bytes);
        return layout;
    }

    void bound(Recorder& recorder, const rsh_bound_desc& desc) const override {
        const rsh_geometry& geometry = desc.geometry;
        if (geometry.triangle_count == 0) {
            // Bounds, and of a shape that no triangles have.
            recorder.fill(RSH_STAGE_BOUND, desc.bounds, RSH_BVH_MADE, sizeof(bvh_head));
            return;
        }
        const Scratch memory(recorder, scratch(recorder.context(), geometry, desc.mode),
                             desc.scratch);
        const BvhLayouts trees = bvh_layouts_of(geometry);
        for (const bvh_layout& tree : trees) {
            const bool is_kept = tree.tree == RSH_STILL_TREE && desc.mode == RSH_BOUND_REFIT;
            if (tree.triangles && !is_kept) bound_tree(recorder, desc, tree, memory["tree"]);
        }
        if (trees[RSH_STILL_TREE].triangles && trees[RSH_MOVING_TREE].triangles)
            recorder.launch(RSH_STAGE_BOUND, tiles_kernel("rsh_join_trees"), {1, 1},
                            bvh_whole_of(geometry), desc.bounds);
    }

private:
    static void bound_tree(Recorder& recorder, const rsh_bound_desc& desc,
                           const bvh_layout& layout, cl_mem scratch) {
        const TreeOfScene tree(recorder, desc, layout, scratch);
        tree.order();
        tree.make();
        tree.refit();
    }
};

}  // namespace

const SceneBounds& bvh16_bounds() {
    static const Bvh16 bounds;
    return bounds;
}

}  // namespace rsh
