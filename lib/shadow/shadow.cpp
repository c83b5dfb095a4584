#include "shadow/shadow.hpp"

#include "bvh/scene_bounds.hpp"
#include "rays/levels.hpp"
#include "rays/node_shape.hpp"
#include "shade/shade.hpp"
#include "shade/spawn.hpp"
#include "traverse/engine.hpp"

namespace rsh {
namespace {

bool has_nodes(const rsh_shadow_desc& desc) {
    return find_engine(desc.engine).node_shape() != RSH_SHAPE_DEFAULT;
}

// Scratch is there once for all lights.
class Shadow {
public:
    Shadow(Recorder& recorder, const rsh_shadow_desc& desc)
        : recorder_(recorder),
          desc_(desc),
          scratch_(recorder, shadow_scratch(recorder.context(), desc), desc.scratch),
          spawn_(spawn_of_lights()),
          build_(build_of_lights()),
          traverse_(traverse_of_lights()) {}

    void cast(cl_uint light) {
        spawn_.light = light;
        spawn(recorder_, spawn_);
        build_.converging = desc_.scene->positional_lights >> light & 1;
        if (has_nodes(desc_)) build(recorder_, build_);
        traverse_.occlusion_bit = light;
        traverse(recorder_, traverse_);
    }

private:
    rsh_spawn_desc spawn_of_lights() const {
        rsh_spawn_desc pass = {};
        pass.struct_size = sizeof pass;
        pass.scene = desc_.scene;
        pass.kind = RSH_SPAWN_SHADOW;
        pass.ray_count = static_cast<cl_uint>(ray_count(desc_.width, desc_.height));
        pass.rays = desc_.rays;
        pass.hits = desc_.hits;
        pass.spawned_rays = scratch_["rays"];
        pass.active_count = desc_.active_count;
        pass.spawned_skip = scratch_["skip"];
        pass.list_count = desc_.list_count;
        return pass;
    }

    rsh_build_desc build_of_lights() const {
        rsh_build_desc pass = {};
        pass.struct_size = sizeof pass;
        pass.rays = scratch_["rays"];
        pass.width = desc_.width;
        pass.height = desc_.height;
        pass.nodes = scratch_.find("nodes");
        pass.shape = desc_.shape;
        pass.scratch = scratch_.find("build scratch");
        pass.list_count = desc_.list_count;
        return pass;
    }

    rsh_traverse_desc traverse_of_lights() const {
        rsh_traverse_desc pass = shadow_traverse(desc_);
        if (has_nodes(desc_) && !pass.bounds)
            pass.bounds = make_bounds(recorder_, pass, scratch_);
        pass.rays = scratch_["rays"];
        pass.nodes = scratch_.find("nodes");
        pass.skip = scratch_["skip"];
        pass.scratch = scratch_["traverse"];
        return pass;
    }

    Recorder& recorder_;
    const rsh_shadow_desc& desc_;
    const Scratch scratch_;
    rsh_spawn_desc spawn_;
    rsh_build_desc build_;
    rsh_traverse_desc traverse_;
};

}  // namespace

rsh_traverse_desc shadow_traverse(const rsh_shadow_desc& desc) {
    rsh_traverse_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.geometry = desc.scene->geometry;
    pass.bounds = desc.bounds;
    pass.width = desc.width;
    pass.height = desc.height;
    pass.query = RSH_QUERY_ANY;
    pass.occlusion = desc.occlusion;
    pass.engine = desc.engine;
    pass.shape = desc.shape;
    pass.strategy = desc.strategy;
    pass.budget = desc.budget;
    pass.list_count = desc.list_count;
    return pass;
}

cl_uint chosen_strategy(const Context& context, const rsh_shadow_desc& desc) {
    return chosen_strategy(context, shadow_traverse(desc));
}

Layout shadow_scratch(const Context& context, const rsh_shadow_desc& desc) {
    const rsh_traverse_desc pass = shadow_traverse(desc);
    const size_t rays = ray_count(desc.width, desc.height);
    Layout layout(context.caps.alignment);
    layout.add_array<rsh_ray>("rays", rays);
    layout.add_array<cl_uint>("skip", rays);
    layout.add("traverse",
               find_engine(desc.engine).scratch(context, pass, BoundsFrom::caller).bytes());
    if (!has_nodes(desc)) return layout;
    const NodeShape& shape = find_shape(desc.shape);
    const ray_levels levels = shape.levels(desc.width, desc.height);
    layout.add("nodes", shape.bytes(levels));
    layout.add("build scratch", shape.scratch(context, levels).bytes());
    reserve_bounds(layout, context, pass, bounds_from(pass));
    return layout;
}

void shadow(Recorder& recorder, const rsh_shadow_desc& desc) {
    const size_t rays = ray_count(desc.width, desc.height);
    const cl_uint lights = shadow_lights(*desc.scene);
    if (rays) recorder.fill(RSH_STAGE_OTHER, desc.occlusion, 0, rays * 4);
    if (rays == 0 || lights == 0) return;
    Shadow shadow(recorder, desc);
    for (cl_uint light = 0; light < desc.scene->light_count; ++light)
        if (lights >> light & 1) shadow.cast(light);
}

}  // namespace rsh
