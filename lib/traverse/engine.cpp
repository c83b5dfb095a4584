#include "traverse/engine.hpp"

#include "bvh/scene_bounds.hpp"
#include "device/error.hpp"
#include "rays/levels.hpp"
#include "rays/node_shape.hpp"
#include "reduce/strategy.hpp"
#include "traverse/list_hits.hpp"

namespace rsh {

void traverse(Recorder& recorder, const rsh_traverse_desc& desc) {
    if (desc.query == RSH_QUERY_ALL)
        list_hits(recorder, desc);
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
    const BoundsFrom bounds = bounds_from(desc);
    return desc.query == RSH_QUERY_ALL
               ? list_scratch(context, desc, bounds)
               : find_engine(desc.engine).scratch(context, desc, bounds);
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
