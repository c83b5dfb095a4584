// box.cpp - a box of origins and a box of directions around 16 rays, 16 such blocks to a tile,
// in kernels/rays/build_boxes.cl; against the BVH16 of the scene.
#include "device/cl/scratch.hpp"
#include "order/sort.hpp"
#include "rays/levels.hpp"
#include "rays/node_shape.hpp"
#include "rays/types.h"
#include "tuning.h"

namespace rsh {
namespace {

Sort sort_of_rays(const Context& context, const ray_levels& list) {
    return {list.width[0], RSH_RAY_BINS, context.caps.compute_units};
}

// rays/sort_rays.cl; the order goes to `nodes`, from word order_at on.
void order_rays(Recorder& recorder, const rsh_build_desc& desc, const ray_levels& list,
                const Scratch& scratch, cl_uint order_at) {
    const Sort sort = sort_of_rays(recorder.context(), list);
    const cl_uint rays = list.width[0];
    recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_sort_rays_measure"), sort.items(),
                    desc.rays, rays, desc.list_count, desc.converging, scratch["samples"],
                    scratch["extents"]);
    recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_sort_rays_keys"), sort.items(),
                    desc.rays, rays, desc.list_count, desc.converging, scratch["samples"],
                    scratch["extents"], scratch["sorting"], scratch["keys"], scratch["bins"]);
    sort.run(recorder, RSH_STAGE_BUILD, scratch, desc.nodes, order_at);
}

class Box final : public NodeShape {
public:
    cl_uint id() const noexcept override { return RSH_SHAPE_BOX; }
    const char* name() const noexcept override { return "box"; }

    ray_levels levels(cl_uint width, cl_uint height) const override {
        return box_levels(width, height);
    }

    size_t bytes(const ray_levels& levels) const override {
        const size_t order = levels.is_list ? levels.width[0] : 0;
        return sizeof(nodes_head) + node_count(levels, 2) * sizeof(box_node16) +
               order * sizeof(cl_uint);
    }

    Layout scratch(const Context& context, const ray_levels& levels) const override {
        Layout layout(context.caps.alignment);
        if (!levels.is_list) return layout;
        const Sort sort = sort_of_rays(context, levels);
        layout.add_array<block_extent>("extents", RSH_SAMPLES * sort.items().items);
        sort.reserve(layout);
        return layout;
    }

    void build(Recorder& recorder, const rsh_build_desc& desc) const override {
        const ray_levels shape = levels(desc.width, desc.height);
        const Scratch memory(recorder, scratch(recorder.context(), shape), desc.scratch);
        const auto order_at = static_cast<cl_uint>(RSH_RAY_ORDER_AT(node_count(shape, 2)));
        if (shape.is_list) order_rays(recorder, desc, shape, memory, order_at);
        recorder.launch(RSH_STAGE_BUILD, tiles_kernel("rsh_build_boxes"),
                        recorder.serial_range(node_count(shape, 2)), shape, desc.list_count,
                        desc.rays, desc.converging, memory.find("sorting"), order_at,
                        desc.nodes);
    }
};

}  // namespace

const NodeShape& box_shape() {
    static const Box shape;
    return shape;
}

}  // namespace rsh
