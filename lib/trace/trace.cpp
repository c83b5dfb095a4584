#include "trace/trace.hpp"

#include "rays/levels.hpp"
#include "rays/node_shape.hpp"
#include "rays/pack_rays.hpp"
#include "traverse/describe_hits.hpp"
#include "traverse/engine.hpp"

namespace rsh {
namespace {

bool has_nodes(const rsh_trace_desc& desc) {
    return find_engine(desc.engine).node_shape() != RSH_SHAPE_DEFAULT;
}

void build_nodes(Recorder& recorder, const rsh_trace_desc& desc, const rsh_traverse_desc& rays,
                 cl_mem scratch) {
    rsh_build_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.rays = rays.rays;
    pass.width = rays.width;
    pass.height = rays.height;
    pass.nodes = rays.nodes;
    pass.converging = desc.converging;
    pass.shape = rays.shape;
    pass.scratch = scratch;
    pass.list_count = rays.list_count;
    build(recorder, pass);
}

}  // namespace

rsh_traverse_desc trace_traverse(const rsh_trace_desc& desc) {
    rsh_traverse_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.geometry = desc.geometry;
    pass.bounds = desc.bounds;
    pass.rays = desc.rays;
    pass.width = desc.width;
    pass.height = desc.height;
    pass.query = desc.query;
    pass.hits = desc.hits;
    pass.occlusion = desc.occlusion;
    pass.occlusion_bit = desc.occlusion_bit;
    pass.hit_counts = desc.hit_counts;
    pass.hit_offsets = desc.hit_offsets;
    pass.hit_capacity = desc.hit_capacity;
    pass.engine = desc.engine;
    pass.shape =
        has_nodes(desc) ? find_engine(desc.engine).node_shape() : cl_uint{RSH_SHAPE_BOX};
    pass.strategy = desc.strategy;
    pass.budget = desc.budget;
    pass.progress = desc.progress;
    pass.progress_user = desc.progress_user;
    pass.skip = desc.skip;
    pass.list_count = desc.list_count;
    pass.ray_masks = desc.ray_masks;
    pass.cull = desc.cull;
    return pass;
}

cl_uint chosen_strategy(const Context& context, const rsh_trace_desc& desc) {
    return chosen_strategy(context, trace_traverse(desc));
}

Layout trace_scratch(const Context& context, const rsh_trace_desc& desc) {
    const rsh_traverse_desc pass = trace_traverse(desc);
    Layout layout(context.caps.alignment);
    if (!desc.rays) layout.add_array<rsh_ray>("rays", ray_count(desc.width, desc.height));
    layout.add("traverse", traverse_scratch(context, pass).bytes());
    if (!has_nodes(desc)) return layout;
    const NodeShape& shape = find_shape(pass.shape);
    const ray_levels levels = shape.levels(desc.width, desc.height);
    layout.add("nodes", shape.bytes(levels));
    layout.add("build scratch", shape.scratch(context, levels).bytes());
    return layout;
}

void trace(Recorder& recorder, const rsh_trace_desc& desc) {
    const Scratch scratch(recorder, trace_scratch(recorder.context(), desc), desc.scratch);
    rsh_traverse_desc pass = trace_traverse(desc);
    if (!desc.rays) pass.rays = scratch["rays"];
    if (!desc.rays) pack_rays(recorder, desc, pass.rays);
    pass.nodes = scratch.find("nodes");
    if (has_nodes(desc)) build_nodes(recorder, desc, pass, scratch["build scratch"]);
    pass.scratch = scratch["traverse"];
    traverse(recorder, pass);
    describe_hits(recorder, pass, {desc.normals, desc.points, desc.geometry_ids});
}

}  // namespace rsh
