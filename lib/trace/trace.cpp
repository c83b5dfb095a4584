#include "trace/trace.hpp"

#include <algorithm>

#include "batches/find_hits.hpp"
#include "device/error.hpp"
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

BatchNeeds needs_of(const rsh_trace_desc& desc) {
    return {desc.batches, desc.batches->attributes & RSH_BATCH_INDICES, desc.engine,
            trace_traverse(desc).shape};
}

// Of so many triangles, and of their traversal.
void add_batch(Layout& layout, const Context& context, const rsh_trace_desc& desc,
               cl_uint triangles) {
    reserve_batch(layout, context, needs_of(desc), triangles);
    layout.add("traverse", batch_scratch_bytes(context, trace_traverse(desc), triangles));
}

void add_nodes(Layout& layout, const Context& context, const rsh_trace_desc& desc) {
    const rsh_traverse_desc pass = trace_traverse(desc);
    if (!desc.rays) layout.add_array<rsh_ray>("rays", ray_count(desc.width, desc.height));
    if (!has_nodes(desc)) return;
    const NodeShape& shape = find_shape(pass.shape);
    const ray_levels levels = shape.levels(desc.width, desc.height);
    layout.add("nodes", shape.bytes(levels));
    layout.add("build scratch", shape.scratch(context, levels).bytes());
}

// Of a batch, at most: what it takes keeps to the caller's budget, or all of the call to the usual one.
cl_uint batch_triangles(const Context& context, const rsh_trace_desc& desc) {
    const rsh_batch_source& source = *desc.batches;
    const auto bytes_of = [&](cl_uint triangles) {
        Layout layout(context.caps.alignment);
        if (!desc.batch_budget) add_nodes(layout, context, desc);
        add_batch(layout, context, desc, triangles);
        return layout.bytes();
    };
    const cl_ulong budget = desc.batch_budget ? desc.batch_budget : context.caps.usual_budget();
    const cl_uint fits = fitting_triangles(source, budget, bytes_of);
    const cl_uint least = least_batch_triangles(source);
    if (fits == 0 && least > 0 && desc.batch_budget)
        throw Error(RSH_INVALID_VALUE, "batch_budget: is ", desc.batch_budget,
                    ", must be 0 or at least ", bytes_of(least));
    return std::max(fits, least);
}

void trace_batches(Recorder& recorder, const rsh_trace_desc& desc, rsh_traverse_desc pass,
                   const Scratch& scratch) {
    const BatchMemory memory = batch_memory(scratch, batch_triangles(recorder.context(), desc));
    const rsh_traverse_desc pass_of_caller = pass;
    cl_uint batch = 0;
    BatchFeed feed(recorder, needs_of(desc), memory,
                   [&] { report_progress(pass_of_caller, batch++, 0); });
    pass.progress = nullptr;  // an engine would call it for batches of its own
    find_hits(recorder, feed, memory, pass, nullptr);
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
    pass.continued = desc.continued;
    pass.first_triangle = desc.first_triangle;
    pass.skip_corners = desc.skip_corners;
    pass.skip_numbers = desc.skip_numbers;
    pass.skip_count = desc.skip_count;
    return pass;
}

cl_uint chosen_strategy(const Context& context, const rsh_trace_desc& desc) {
    return chosen_strategy(context, trace_traverse(desc));
}

Layout trace_scratch(const Context& context, const rsh_trace_desc& desc) {
    Layout layout(context.caps.alignment);
    add_nodes(layout, context, desc);
    if (desc.batches)
        add_batch(layout, context, desc, batch_triangles(context, desc));
    else
        layout.add("traverse", traverse_scratch(context, trace_traverse(desc)).bytes());
    return layout;
}

void trace(Recorder& recorder, const rsh_trace_desc& desc) {
    if (desc.batches) recorder.wait_for_callers();
    const Scratch scratch(recorder, trace_scratch(recorder.context(), desc), desc.scratch);
    rsh_traverse_desc pass = trace_traverse(desc);
    if (!desc.rays) pass.rays = scratch["rays"];
    if (!desc.rays) pack_rays(recorder, desc, pass.rays);
    pass.nodes = scratch.find("nodes");
    if (has_nodes(desc)) build_nodes(recorder, desc, pass, scratch["build scratch"]);
    pass.scratch = scratch["traverse"];
    if (desc.batches) return trace_batches(recorder, desc, pass, scratch);
    traverse(recorder, pass);
    describe_hits(recorder, pass, {desc.normals, desc.points, desc.geometry_ids});
}

}  // namespace rsh
