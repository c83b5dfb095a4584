// brute_force.cpp - every ray against every triangle (traverse/brute_force.cl): what the others
// must equal.
#include "mesh/mesh.hpp"
#include "rays/levels.hpp"
#include "traverse/engine.hpp"
#include "traverse/intersect.hpp"
#include "tuning.h"

namespace rsh {
namespace {

class BruteForce final : public Engine {
public:
    cl_uint id() const noexcept override { return RSH_ENGINE_BRUTE_FORCE; }
    const char* name() const noexcept override { return "brute_force"; }
    cl_uint node_shape() const noexcept override { return RSH_SHAPE_DEFAULT; }
    bool counts_tests_per_ray() const noexcept override { return true; }

    Layout scratch(const Context& context, const rsh_traverse_desc&,
                   BoundsFrom) const override {
        return Layout(context.caps.alignment);
    }

    void traverse(Recorder& recorder, const rsh_traverse_desc& desc) const override {
        const rsh_geometry& geometry = desc.geometry;
        const cl_uint rays = static_cast<cl_uint>(ray_count(desc.width, desc.height));
        const size_t rays_per_item =
            size_t{RSH_VECTORS_PER_ITEM} * recorder.context().vector_width;
        const Answers answers = answers_of(desc);
        launch_hits(
            recorder, desc, RSH_STAGE_INTERSECT,
            hit_kernel(desc, "traverse/brute_force", "traverse/brute_force", "rsh_brute_force"),
            recorder.serial_range((rays + rays_per_item - 1) / rays_per_item),
            mesh_view_of(geometry), geometry.vertices, geometry.indices, desc.rays, desc.skip,
            rays, desc.list_count, answers.hits, answers.occlusion, answers.occlusion_bit,
            desc.tests_per_ray);
    }
};

}  // namespace

const Engine& brute_force_engine() {
    static const BruteForce engine;
    return engine;
}

}  // namespace rsh
