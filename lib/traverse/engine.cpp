#include "traverse/engine.hpp"

#include "bvh/scene_bounds.hpp"
#include "device/error.hpp"
#include "rays/levels.hpp"
#include "rays/node_shape.hpp"
#include "reduce/strategy.hpp"
#include "traverse/list_hits.hpp"
#include "traverse/merge_hits.hpp"

namespace rsh {
namespace {

// Of batches of a scene, for an engine that knows of one.
bool is_merged(const rsh_traverse_desc& desc) {
    return desc.query == RSH_QUERY_CLOSEST && (desc.continued || desc.first_triangle) &&
           !find_engine(desc.engine).continues_hits();
}

Layout merged_scratch(const Context& context, const rsh_traverse_desc& desc,
                      BoundsFrom bounds) {
    const size_t rays = ray_count(desc.width, desc.height);
    Layout layout(context.caps.alignment);
    if (desc.continued) layout.add_array<rsh_ray>("shortened", rays);
    layout.add_array<rsh_hit>("found", rays);
    layout.add("engine scratch",
               find_engine(desc.engine).scratch(context, desc, bounds).bytes());
    return layout;
}

void traverse_merged(Recorder& recorder, const rsh_traverse_desc& desc) {
    const Scratch scratch(recorder, merged_scratch(recorder.context(), desc, bounds_from(desc)),
                          desc.scratch);
    rsh_traverse_desc pass = desc;
    pass.hits = scratch["found"];
    pass.scratch = scratch["engine scratch"];
    if (desc.continued) {
        pass.rays = scratch["shortened"];
        shorten_rays(recorder, desc, pass.rays);
    }
    find_engine(desc.engine).traverse(recorder, pass);
    merge_hits(recorder, desc, pass.hits);
}

}  // namespace

void traverse(Recorder& recorder, const rsh_traverse_desc& desc) {
    if (desc.query == RSH_QUERY_ALL)
        list_hits(recorder, desc);
    else if (is_merged(desc))
        traverse_merged(recorder, desc);
    else
        find_engine(desc.engine).traverse(recorder, desc);
    if (!recorder.context().statistics.enabled()) return;
    recorder.count([](rsh_statistics& sums) { ++sums.traversals; });
    recorder.count_later(
        recorder.wrong_buffers(), 1,
        [](rsh_statistics& sums, const cl_uint* bits) { sums.wrong_buffers |= *bits; });
}

cl_ulong answer_bytes(const rsh_traverse_desc& desc) {
    const cl_ulong rays = ray_count(desc.width, desc.height);
    if (desc.query == RSH_QUERY_ALL) return desc.hit_capacity * sizeof(rsh_hit);
    return rays * (desc.query == RSH_QUERY_CLOSEST ? sizeof(rsh_hit) : sizeof(cl_uint));
}

Layout traverse_scratch(const Context& context, const rsh_traverse_desc& desc) {
    return traverse_scratch(context, desc, bounds_from(desc));
}

Layout traverse_scratch(const Context& context, const rsh_traverse_desc& desc,
                        BoundsFrom bounds) {
    if (desc.query == RSH_QUERY_ALL) return list_scratch(context, desc, bounds);
    if (is_merged(desc)) return merged_scratch(context, desc, bounds);
    return find_engine(desc.engine).scratch(context, desc, bounds);
}

cl_uint chosen_strategy(const Context& context, const rsh_traverse_desc& desc) {
    const cl_uint count = find_engine(desc.engine).longest_stream(desc);
    return count ? chosen_strategy(context, desc.strategy, count) : desc.strategy;
}

void check_node_shape(const Engine& engine, cl_uint shape) {
    const NodeShape& given = find_shape(shape);
    const cl_uint taken = engine.node_shape();
    if (taken == RSH_SHAPE_DEFAULT || taken == given.id()) return;
    throw Error(RSH_INVALID_VALUE, "shape: is ", given.name(), ", must be ",
                find_shape(taken).name(), " with engine ", engine.name());
}

void reserve_bounds(Layout& scratch, const Context& context, const rsh_traverse_desc& desc,
                    BoundsFrom from) {
    if (from == BoundsFrom::caller) return;
    const SceneBounds& bounds = bounds_for(desc.shape);
    scratch.add("bounds", bounds.bytes(desc.geometry));
    scratch.add("bound scratch",
                bounds.scratch(context, desc.geometry, RSH_BOUND_FAST).bytes());
}

cl_mem make_bounds(Recorder& recorder, const rsh_traverse_desc& desc, const Scratch& scratch) {
    rsh_bound_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.geometry = desc.geometry;
    pass.shape = desc.shape;
    pass.bounds = scratch["bounds"];
    pass.scratch = scratch["bound scratch"];
    bound(recorder, pass);
    return pass.bounds;
}

void report_progress(const rsh_traverse_desc& desc, cl_uint batch, cl_uint batch_count) {
    if (desc.progress && desc.progress(batch, batch_count, desc.progress_user))
        throw Error(RSH_CANCELLED, "progress: asked to stop before batch ", batch);
}

}  // namespace rsh
