// layout.cpp - how much memory a frame takes, part by part.
#include <algorithm>

#include "batches/find_hits.hpp"
#include "bvh/scene_bounds.hpp"
#include "camera/rasterize.hpp"
#include "frame/memory.hpp"
#include "frame/passes.hpp"
#include "frame/strips.hpp"
#include "rays/node_shape.hpp"
#include "reduce/strategy.hpp"
#include "traverse/engine.hpp"

namespace rsh {
namespace {

// What traversals of up to that many rays need, in a screen or in a list. A last strip of one row is
// a list as well.
void add_traversal(Layout& layout, const Context& context, const rsh_frame_desc& desc,
                   cl_uint batch_triangles) {
    const NodeShape& shape = find_shape(desc.shape);
    size_t nodes = 0, build = 0, traverse = 0;
    const auto reserve = [&](cl_uint width, cl_uint height) {
        const ray_levels levels = shape.levels(width, height);
        nodes = std::max(nodes, shape.bytes(levels));
        build = std::max(build, shape.scratch(context, levels).bytes());
        const rsh_traverse_desc pass = traverse_of(desc, width, height);
        traverse = std::max(traverse,
                            desc.batches
                                ? batch_scratch_bytes(context, pass, batch_triangles)
                                : traverse_scratch(context, pass, BoundsFrom::caller).bytes());
    };
    const bool has_lists = needs_bounces(desc) || is_approximate(desc);
    reserve(desc.width, desc.height);
    reserve(has_lists ? desc.width * desc.height : desc.width, 1);
    const pixel_grid grid = grid_of(desc.width, desc.height, RSH_WIDEST_STEP);
    if (is_approximate(desc)) reserve(grid.columns, grid.rows);
    layout.add("nodes", nodes);
    layout.add("build scratch", build);
    layout.add("traverse", traverse);
}

// What rays below the camera's need, and only if there are any.
void add_secondary(Layout& layout, const Context& context, const rsh_frame_desc& desc,
                   cl_uint batch_triangles) {
    layout.add_array<cl_uint>("wrong buffers", 1);
    layout.add_array<cl_uint>("skip", size_t{desc.width} * desc.height);
    add_traversal(layout, context, desc, batch_triangles);
}

void add_bounds(Layout& layout, const Context& context, const rsh_frame_desc& desc) {
    const SceneBounds& bounds = bounds_for(find_shape(desc.shape).id());
    const rsh_geometry& geometry = desc.scene->geometry;
    if (!desc.bounds) layout.add("bounds", bounds.bytes(geometry));
    layout.add("bound scratch", bounds.scratch(context, geometry, desc.mode).bytes());
}

// The triangles that the rays of each wave hit, and the batch that they are taken from.
void add_batches(Layout& layout, const Context& context, const rsh_frame_desc& desc,
                 cl_uint batch_triangles) {
    const BatchNeeds needs = batch_needs(desc);
    const size_t rays = size_t{desc.width} * desc.height;
    const cl_uint waves = needs_bounces(desc) ? desc.bounces + 1 : 1;
    for (cl_uint bounce = 0; bounce < waves; ++bounce)
        reserve_seen(layout, needs.attributes, bounce, rays);
    reserve_batch(layout, context, needs, batch_triangles);
}

void add_waves(Layout& layout, const Context& context, const rsh_frame_desc& desc) {
    const size_t pixels = size_t{desc.width} * desc.height;
    for (cl_uint bounce = 0; bounce <= desc.bounces; ++bounce) {
        if (bounce < desc.bounces)
            layout.add_array<cl_uint>(numbered("branches", bounce), RSH_BRANCHES * pixels);
        if (bounce == 0) continue;
        layout.add_array<cl_uint>(numbered("list count", bounce), 1);
        layout.add_array<rsh_ray>(numbered("rays", bounce), pixels);
        layout.add_array<rsh_hit>(numbered("hits", bounce), pixels);
        layout.add_array<rsh_float4>(numbered("weights", bounce), pixels);
        layout.add_array<rsh_float4>(numbered("colour", bounce), pixels);
    }
    layout.add_array<cl_uint>("spawned counts", desc.bounces + 1);
    layout.add_array<cl_uint>("branch counts",
                              wave_count_words(context, desc.width, desc.height));
}

// What an approximate frame needs beside the waves, whose first one holds some of the pixels.
void add_pixels(Layout& layout, const Context& context, const rsh_frame_desc& desc) {
    const size_t pixels = size_t{desc.width} * desc.height;
    const rsh_reduce_desc pack = pack_listed_of(desc);
    layout.add_array<rsh_ray>("screen rays", pixels);
    layout.add_array<rsh_hit>("screen hits", pixels);
    layout.add_array<rsh_float4>("colour 0", pixels);
    layout.add_array<cl_uint>("listed pixels", pack.count);
    layout.add_array<cl_uint>("rest pixels", pixels);
    layout.add_array<cl_uint>("rest count", 1);
    layout.add("pack pixels", reduce_scratch(context, pack).bytes());
}

}  // namespace

// By the streams of a frame without a budget. If the budget had a say, the least one, which is found with
// the strategy of a smaller one, might be too little for its own.
cl_uint chosen_strategy(const Context& context, const rsh_frame_desc& asked) {
    rsh_frame_desc desc = asked;
    desc.budget = 0;
    const rsh_traverse_desc traverse = traverse_of(desc, desc.width, desc.height);
    if (!is_approximate(desc)) return chosen_strategy(context, traverse);
    return chosen_strategy(context, desc.strategy,
                           std::max(find_engine(desc.engine).longest_stream(traverse),
                                    pack_listed_of(desc).count));
}

Layout frame_scratch(const Context& context, const rsh_frame_desc& desc) {
    return strip_scratch(context, desc, strip_size(context, desc));
}

Layout strip_scratch(const Context& context, const rsh_frame_desc& whole,
                     const StripSize& size) {
    rsh_frame_desc desc = whole;
    desc.height = size.rows;
    const size_t pixels = size_t{desc.width} * desc.height;
    Layout layout(context.caps.alignment);
    layout.add_array<rsh_ray>("rays 0", pixels);
    layout.add_array<rsh_hit>("hits 0", pixels);
    if (is_approximate(desc)) add_pixels(layout, context, desc);
    if (needs_bounces(desc)) add_waves(layout, context, desc);
    layout.add_array<cl_uint>("active count", 1);
    layout.add("rasterize", rasterize_scratch(context, rasterize_of(desc)).bytes());
    if (needs_shadows(desc)) {
        layout.add_array<rsh_ray>("shadow rays", pixels);
        layout.add_array<cl_uint>("occlusion", pixels);
        layout.add_array<rsh_float4>("light colour", pixels);
    }
    if (needs_traversals(desc)) add_secondary(layout, context, desc, size.triangles);
    if (desc.batches)
        add_batches(layout, context, desc, size.triangles);
    else if (needs_traversals(desc))
        add_bounds(layout, context, desc);
    return layout;
}

}  // namespace rsh
