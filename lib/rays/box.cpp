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
class SceneBoxes {
public:
    SceneBoxes(Recorder& recorder, const rsh_bound_desc& desc, const Scratch& scratch)
        : recorder_(recorder), desc_(desc), scratch_(scratch) {}

    // bvh/order.cl.
    void order() const {
        if (is_update_) survey(scratch_["surveys"], 0, false);
        launch("rsh_order_measure", sort_.items(), shape_, is_update_, scratch_["surveys"],
               desc_.bounds, scratch_["spans"], scratch_["sorting"]);
        launch("rsh_order_keys", sort_.items(), desc_.bounds, cell_bits(mesh_.triangle_count),
               scratch_["spans"], scratch_["sorting"], scratch_["keys"], scratch_["bins"]);
        sort_.run(recorder_, RSH_STAGE_BOUND, scratch_, desc_.bounds, RSH_ORDER_AT(shape_));
        survey(desc_.bounds, RSH_SURVEYS_AT(shape_), true);
    }

    // bvh/leaves.cl: where the order is a new one.
    void make() const {
        const cl_uint spans = sort_.items().items, is_kept = desc_.update != RSH_UPDATE_NONE;
        launch("rsh_bound_clusters", parts(), shape_, scratch_["sorting"], spans,
               scratch_["spans"], is_kept, desc_.bounds, scratch_["loose"], scratch_["tree"]);
        if (!is_kept) {
            launch_above("rsh_bound_levels", {1, 1}, scratch_["sorting"], spans,
                         scratch_["spans"], desc_.bounds, scratch_["loose"]);
            return;
        }
        launch_above("rsh_bound_top", {1, 1}, scratch_["sorting"], spans, scratch_["spans"],
                     desc_.bounds, scratch_["loose"], scratch_["tree"]);
        launch_above("rsh_bound_groups", parts(), scratch_["sorting"], desc_.bounds,
                     scratch_["loose"], scratch_["tree"]);
    }

    // bvh/refit.cl: where the order was kept.
    void refit() const {
        if (!is_update_) return;
        launch("rsh_refit_clusters", parts(), shape_, scratch_["sorting"], desc_.bounds,
               scratch_["loose"]);
        launch_above("rsh_refit_groups", {1, 1}, scratch_["sorting"], desc_.bounds,
                     scratch_["loose"]);
    }

private:
    void survey(cl_mem surveys, cl_ulong first, bool is_record) const {
        launch("rsh_order_survey", {RSH_SURVEYS, 1}, shape_, cl_uint{is_record},
               scratch_["sorting"], desc_.bounds, surveys, first);
    }

    Range parts() const { return recorder_.serial_range(shape_.parts); }

    template <class... Arguments>
    void launch(const char* kernel, Range range, const Arguments&... arguments) const {
        recorder_.launch(RSH_STAGE_BOUND, tiles_kernel(kernel), range, mesh_,
                         desc_.geometry.vertices, desc_.geometry.indices, arguments...);
    }

    // What does not look at triangles.
    template <class... Arguments>
    void launch_above(const char* kernel, Range range, const Arguments&... arguments) const {
        recorder_.launch(RSH_STAGE_BOUND, tiles_kernel(kernel), range, shape_, arguments...);
    }

    Recorder& recorder_;
    const rsh_bound_desc& desc_;
    const Scratch& scratch_;
    const cl_uint is_update_ = desc_.update == RSH_UPDATE_NEXT;
    const rsh_mesh mesh_ = mesh_of(desc_.geometry);
    const rsh_scene_shape shape_ = scene_shape(mesh_.triangle_count);
    const Sort sort_ = sort_of_triangles(recorder_.context(), mesh_.triangle_count);
};

// rays/sort_rays.cl: behind the groups of a list's blocks.
void order_rays(Recorder& recorder, const rsh_build_desc& desc, const rsh_levels& list,
                const Scratch& scratch) {
    const Sort sort = sort_of_rays(recorder.context(), list);
    const cl_uint rays = list.width[0];
    recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_rays_measure"), sort.items(), desc.rays,
                    rays, scratch["spans"]);
    recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_rays_ask"), sort.items(), desc.rays,
                    rays, scratch["spans"], scratch["asked"]);
    recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_rays_keys"), sort.items(), desc.rays,
                    rays, scratch["spans"], scratch["asked"], scratch["sorting"],
                    scratch["keys"], scratch["bins"]);
    sort.run(recorder, RSH_STAGE_BUILD, scratch, desc.nodes,
             RSH_RAY_ORDER_AT(node_count(list, 2)));
    recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_build_order"), {1, 1}, list,
                    scratch["sorting"], desc.nodes);
}

}  // namespace

rsh_levels Box::levels(cl_uint width, cl_uint height) const {
    rsh_levels levels = ray_level(width, height);
    levels.fan = 4;
    add_level(levels);
    add_level(levels);
    return levels;
}

size_t Box::node_bytes(const rsh_levels& levels) const {
    const size_t order = levels.is_list ? size_t{levels.width[0]} + 1 : 0;
    return node_count(levels, 2) * sizeof(rsh_node_group) + order * sizeof(cl_uint);
}

size_t Box::scene_bytes(const rsh_geometry& geometry) const {
    const rsh_scene_shape shape = scene_shape(geometry.triangle_count);
    return RSH_BOUND_WORDS(shape) * sizeof(cl_uint);
}

Layout Box::bound_scratch(const Context& context, const rsh_geometry& geometry,
                          cl_uint update) const {
    Layout layout(context.caps.alignment);
    layout.add_array<rsh_survey>("surveys", RSH_SURVEYS);
    sort_of_triangles(context, geometry.triangle_count).reserve(layout);
    const rsh_scene_shape shape = scene_shape(geometry.triangle_count);
    layout.reuse_from(Sort::kOnlyWhileSorting);
    layout.add_array<rsh_loose_box>("loose", RSH_CLUSTERS(shape) + RSH_GROUPS(shape));
    if (update != RSH_UPDATE_NONE) layout.add_array<cl_float>("tree", RSH_TREE_WORDS(shape));
    return layout;
}

Layout Box::build_scratch(const Context& context, const rsh_levels& levels) const {
    Layout layout(context.caps.alignment);
    if (!levels.is_list) return layout;
    const Sort sort = sort_of_rays(context, levels);
    layout.add_array<cl_uint>("asked", 2 * sort.items().items);
    sort.reserve(layout);
    return layout;
}

void Box::bound(Recorder& recorder, const rsh_bound_desc& desc) const {
    const rsh_geometry& geometry = desc.geometry;
    if (geometry.triangle_count == 0) {
        recorder.fill(RSH_STAGE_BOUND, desc.bounds, 0, sizeof(rsh_bounds_head));
        return;
    }
    const Scratch scratch(recorder, bound_scratch(recorder.context(), geometry, desc.update),
                          desc.scratch);
    const SceneBoxes boxes(recorder, desc, scratch);
    boxes.order();
    boxes.make();
    boxes.refit();
}

void Box::build(Recorder& recorder, const rsh_build_desc& desc) const {
    const rsh_levels shape = levels(desc.width, desc.height);
    const Scratch scratch(recorder, build_scratch(recorder.context(), shape), desc.scratch);
    if (shape.is_list) order_rays(recorder, desc, shape, scratch);
    recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_build_blocks"),
                    recorder.serial_range(node_count(shape, 2)), shape, desc.rays,
                    desc.converging, desc.nodes);
}

}  // namespace rsh
