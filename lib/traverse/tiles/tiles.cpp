// tiles.cpp - each work-item finishes a tile of 256 rays on its own
// (traverse/tiles/traverse_tiles.cl): boxes of the scene front to back, and nothing behind the
// tile's farthest hit.
#include "bvh/layout.hpp"
#include "mesh/mesh.hpp"
#include "rays/levels.hpp"
#include "rays/node_shape.hpp"
#include "traverse/engine.hpp"
#include "traverse/intersect.hpp"
#include "traverse/types.h"

namespace rsh {
namespace {

constexpr size_t kCountWords = 4;  // node tests, ray tests

void count_tests(Recorder& recorder, cl_mem counts) {
    recorder.count_later(counts, kCountWords, [](rsh_statistics& sums, const cl_uint* tests) {
        ++sums.batches;
        sums.node_tests += count_of(tests);
        sums.ray_tests += count_of(tests + 2);
    });
}

// One that counts ray by ray is a program of its own: the other one pays nothing for it.
KernelName traversal_kernel(const rsh_traverse_desc& desc) {
    KernelName kernel = hit_kernel(desc, "programs/tiles", "traverse/tiles/traverse_tiles",
                                   "rsh_traverse_tiles");
    if (desc.tests_per_ray) kernel.options += " -D RSH_TESTS_PER_RAY=1";
    return kernel;
}

class Tiles final : public Engine {
public:
    cl_uint id() const noexcept override { return RSH_ENGINE_TILES; }
    const char* name() const noexcept override { return "tiles"; }
    cl_uint node_shape() const noexcept override { return RSH_SHAPE_BOX; }
    // A work-item holds a whole tile's packets, kilobytes of private memory.
    bool suits(const DeviceCaps& caps) const noexcept override { return caps.is_cpu; }
    bool counts_tests_per_ray() const noexcept override { return true; }
    bool continues_hits() const noexcept override { return true; }
    cl_uint packed_hits() const noexcept override { return RSH_HIT_ROWS; }

    Layout scratch(const Context& context, const rsh_traverse_desc& desc,
                   BoundsFrom from) const override {
        Layout layout(context.caps.alignment);
        layout.add_array<cl_uint>("counts", kCountWords);
        reserve_bounds(layout, context, desc, from);
        return layout;
    }

    void traverse(Recorder& recorder, const rsh_traverse_desc& desc) const override {
        if (desc.width == 0) return;
        const Context& context = recorder.context();
        const Scratch memory(recorder, scratch(context, desc, bounds_from(desc)), desc.scratch);
        const cl_mem bounds = desc.bounds ? desc.bounds : make_bounds(recorder, desc, memory);
        const bool is_counting = context.statistics.enabled();
        report_progress(desc, 0, 1);
        if (is_counting) recorder.fill(RSH_STAGE_OTHER, memory["counts"], 0, kCountWords * 4);
        const Answers answers = answers_of(desc);
        const ray_levels shape = find_shape(RSH_SHAPE_BOX).levels(desc.width, desc.height);
        launch_hits(recorder, desc, RSH_STAGE_INTERSECT, traversal_kernel(desc),
                    recorder.serial_range(node_count(shape, 2)), bvh_whole_of(desc.geometry),
                    bounds, mesh_view_of(desc.geometry), desc.geometry.vertices,
                    desc.geometry.indices, shape, desc.list_count, desc.rays, desc.skip,
                    desc.nodes, answers.hits, answers.occlusion, answers.occlusion_bit,
                    cl_uint{is_counting}, memory["counts"], desc.tests_per_ray,
                    recorder.wrong_buffers());
        if (is_counting) count_tests(recorder, memory["counts"]);
    }
};

}  // namespace

const Engine& tiles_engine() {
    static const Tiles engine;
    return engine;
}

}  // namespace rsh
