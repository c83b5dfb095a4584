#include "frame/memory.hpp"

#include <algorithm>

#include "bvh/scene_bounds.hpp"
#include "camera/rasterize.hpp"
#include "device/cl/span.hpp"
#include "frame/strips.hpp"
#include "rays/node_shape.hpp"
#include "reduce/strategy.hpp"
#include "traverse/engine.hpp"

namespace rsh {
namespace {

bool needs_shadows(const rsh_frame_desc& desc) {
    return shadow_lights(*desc.scene) != 0;
}

bool needs_bounces(const rsh_frame_desc& desc) {
    return desc.bounces > 0 &&
           (desc.scene->features & (RSH_FEATURE_REFLECTION | RSH_FEATURE_REFRACTION)) != 0;
}

// Where no rays come after the camera's, there is nothing to leave out.
bool is_approximate(const rsh_frame_desc& desc) {
    return desc.tolerance > 0 && (needs_shadows(desc) || needs_bounces(desc));
}

std::string numbered(const char* name, cl_uint bounce) {
    return std::string(name) + ' ' + std::to_string(bounce);
}

rsh_rasterize_desc rasterize_of(const rsh_frame_desc& desc) {
    rsh_rasterize_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.geometry = desc.scene->geometry;
    pass.camera = desc.camera;
    pass.width = desc.width;
    pass.height = desc.height;
    pass.window = desc.window;
    return pass;
}

// Of what a frame may take, for the streams of pairs.
size_t stream_budget(const rsh_frame_desc& desc) {
    return desc.budget ? std::max<size_t>(desc.budget / 8, RSH_MIN_BUDGET) : 0;
}

rsh_traverse_desc traverse_of(const rsh_frame_desc& desc, cl_uint width, cl_uint height) {
    rsh_traverse_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.geometry = desc.scene->geometry;
    pass.width = width;
    pass.height = height;
    pass.engine = desc.engine;
    pass.shape = desc.shape;
    pass.strategy = desc.strategy;
    pass.budget = stream_budget(desc);
    return pass;
}

// What traversals of up to that many rays need, in a screen or in a list. A last strip of one row is
// a list as well.
void add_traversal(Layout& layout, const Context& context, const rsh_frame_desc& desc) {
    const NodeShape& shape = find_shape(desc.shape);
    const Engine& engine = find_engine(desc.engine);
    size_t nodes = 0, build = 0, traverse = 0;
    const auto reserve = [&](cl_uint width, cl_uint height) {
        const ray_levels levels = shape.levels(width, height);
        nodes = std::max(nodes, shape.bytes(levels));
        build = std::max(build, shape.scratch(context, levels).bytes());
        const rsh_traverse_desc pass = traverse_of(desc, width, height);
        traverse =
            std::max(traverse, engine.scratch(context, pass, BoundsFrom::caller).bytes());
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
void add_secondary(Layout& layout, const Context& context, const rsh_frame_desc& desc) {
    const SceneBounds& bounds = bounds_for(find_shape(desc.shape).id());
    const rsh_geometry& geometry = desc.scene->geometry;
    layout.add_array<cl_uint>("wrong buffers", 1);
    layout.add_array<cl_uint>("skip", size_t{desc.width} * desc.height);
    if (!desc.bounds) layout.add("bounds", bounds.bytes(geometry));
    layout.add("bound scratch", bounds.scratch(context, geometry, desc.mode).bytes());
    add_traversal(layout, context, desc);
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

// Packs what blend_pixels lists; of the finest grid that it is given, most.
rsh_reduce_desc pack_listed_of(const rsh_frame_desc& desc, cl_uint step = 2) {
    rsh_reduce_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.strategy = desc.strategy;
    pass.keep = RSH_KEEP_NOT_NULL;
    pass.element_bytes = sizeof(cl_uint);
    pass.count = listed_words(grid_of(desc.width, desc.height, step));
    return pass;
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

cl_uint chosen_strategy(const Context& context, const rsh_frame_desc& desc) {
    const rsh_traverse_desc traverse = traverse_of(desc, desc.width, desc.height);
    if (!is_approximate(desc)) return chosen_strategy(context, traverse);
    return chosen_strategy(context, desc.strategy,
                           std::max(find_engine(desc.engine).longest_stream(traverse),
                                    pack_listed_of(desc).count));
}

Layout frame_scratch(const Context& context, const rsh_frame_desc& desc) {
    return strip_scratch(context, desc, strip_rows(context, desc));
}

Layout strip_scratch(const Context& context, const rsh_frame_desc& whole, cl_uint rows) {
    rsh_frame_desc desc = whole;
    desc.height = rows;
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
    if (needs_shadows(desc) || needs_bounces(desc)) add_secondary(layout, context, desc);
    return layout;
}

FrameMemory::FrameMemory(Recorder& recorder, const rsh_frame_desc& desc)
    : whole_(desc),
      rows_(strip_rows(recorder.context(), desc)),
      desc_(desc),
      scratch_(recorder, strip_scratch(recorder.context(), desc, rows_), desc.scratch) {}

bool FrameMemory::take_strip(cl_uint first_row) {
    if (first_row >= whole_.height) return false;
    desc_.height = std::min(rows_, whole_.height - first_row);
    desc_.window.y = whole_.window.y + first_row;
    desc_.window.picture_height = picture_side(whole_.window.picture_height, whole_.height);
    desc_.window.picture_width = picture_side(whole_.window.picture_width, whole_.width);
    const size_t row = size_t{desc_.width} * sizeof(rsh_float4);
    grid_ = grid_of(desc_.width, desc_.height, RSH_WIDEST_STEP);
    colour_ = part_of(span_of(whole_.colour), row * first_row, row * desc_.height);
    return true;
}

cl_mem FrameMemory::at(const char* name, cl_uint bounce) const {
    return scratch_[numbered(name, bounce)];
}

// Those of the camera are counted by the host.
cl_mem FrameMemory::list_count(const Wave& wave) const {
    return wave.bounce > 0 ? at("list count", wave.bounce) : nullptr;
}

// The camera's rays weigh 1.
cl_mem FrameMemory::weights(const Wave& wave) const {
    return wave.bounce > 0 ? at("weights", wave.bounce) : nullptr;
}

cl_mem FrameMemory::bounds() const {
    return desc_.bounds ? desc_.bounds : scratch_["bounds"];
}

bool FrameMemory::traces_rays() const {
    return needs_shadows(desc_) || needs_bounces(desc_);
}

bool FrameMemory::casts_shadows() const {
    return needs_shadows(desc_);
}

bool FrameMemory::has_bounces() const {
    return needs_bounces(desc_);
}

bool FrameMemory::is_approximate() const {
    return rsh::is_approximate(desc_);
}

rsh_rasterize_desc FrameMemory::rasterize() const {
    const PixelPass all = pixels();
    rsh_rasterize_desc pass = rasterize_of(desc_);
    pass.rays = all.screen_rays;
    pass.hits = all.screen_hits;
    pass.scratch = scratch_["rasterize"];
    return pass;
}

rsh_bound_desc FrameMemory::bound() const {
    return {sizeof(rsh_bound_desc),
            desc_.scene->geometry,
            desc_.shape,
            bounds(),
            scratch_["bound scratch"],
            desc_.mode};
}

rsh_build_desc FrameMemory::build(const Wave& wave) const {
    rsh_build_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.rays = at("rays", wave.bounce);
    pass.width = wave.width;
    pass.height = wave.height;
    pass.nodes = scratch_["nodes"];
    pass.shape = desc_.shape;
    pass.scratch = scratch_["build scratch"];
    pass.list_count = list_count(wave);
    return pass;
}

rsh_traverse_desc FrameMemory::traverse(const Wave& wave) const {
    rsh_traverse_desc pass = traverse_of(desc_, wave.width, wave.height);
    pass.bounds = bounds();
    pass.rays = at("rays", wave.bounce);
    pass.nodes = scratch_["nodes"];
    pass.hits = at("hits", wave.bounce);
    pass.scratch = scratch_["traverse"];
    pass.skip = skip();
    pass.list_count = list_count(wave);
    return pass;
}

rsh_audit_desc FrameMemory::audit(const Wave& wave) const {
    rsh_audit_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.geometry = desc_.scene->geometry;
    pass.ray_count = wave.rays();
    pass.rays = at("rays", wave.bounce);
    pass.hits = at("hits", wave.bounce);
    pass.sample = desc_.audit_rays;
    pass.seed = desc_.audit_seed;
    pass.report = desc_.audit;
    pass.skip = wave.bounce > 0 ? skip() : nullptr;
    pass.list_count = list_count(wave);
    return pass;
}

rsh_audit_desc FrameMemory::audit_screen() const {
    const PixelPass all = pixels();
    rsh_audit_desc pass = audit(screen());
    pass.rays = all.screen_rays;
    pass.hits = all.screen_hits;
    return pass;
}

// Of all pixels; where none is left out, the first wave.
PixelPass FrameMemory::pixels() const {
    PixelPass pass = {};
    pass.grid = grid_;
    pass.rays = at("rays", 0);
    pass.hits = at("hits", 0);
    pass.colour = colour(0);
    pass.screen_rays = is_approximate() ? scratch_["screen rays"] : pass.rays;
    pass.screen_hits = is_approximate() ? scratch_["screen hits"] : pass.hits;
    pass.picture = colour_.get();
    return pass;
}

PixelPass FrameMemory::grid_pixels() const {
    PixelPass pass = pixels();
    pass.count = grid().rays();
    return pass;
}

PixelPass FrameMemory::rest_pixels(cl_uint count) const {
    PixelPass pass = pixels();
    pass.pixels = scratch_["rest pixels"];
    pass.count = count;
    return pass;
}

BlendPass FrameMemory::blend(cl_uint step) const {
    return {desc_.scene,     grid_of(desc_.width, desc_.height, step),
            desc_.tolerance, scratch_["screen hits"],
            colour_.get(),   scratch_["listed pixels"]};
}

rsh_reduce_desc FrameMemory::pack_listed(cl_uint step) const {
    rsh_reduce_desc pass = pack_listed_of(desc_, step);
    pass.input = scratch_["listed pixels"];
    pass.output = scratch_["rest pixels"];
    pass.output_count = rest_count();
    pass.scratch = scratch_["pack pixels"];
    return pass;
}

rsh_shade_desc FrameMemory::shade(const Wave& wave) const {
    rsh_shade_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.scene = desc_.scene;
    pass.ray_count = wave.rays();
    pass.rays = at("rays", wave.bounce);
    pass.hits = at("hits", wave.bounce);
    pass.weights = weights(wave);
    pass.occlusion = occlusion();
    pass.colour = colour(wave.bounce);
    pass.list_count = list_count(wave);
    return pass;
}

WavePass FrameMemory::next(const Wave& wave, const wave_part& part, bool is_counted) const {
    WavePass pass = {};
    pass.scene = desc_.scene;
    pass.part = part;
    pass.list_count = is_counted ? list_count(wave) : nullptr;
    pass.min_weight = desc_.min_weight;
    pass.rays = at("rays", wave.bounce);
    pass.hits = at("hits", wave.bounce);
    pass.weights = weights(wave);
    pass.branches = at("branches", wave.bounce);
    pass.counts = scratch_["branch counts"];
    pass.bounce = wave.bounce;
    pass.spawned_counts = spawned_counts();
    pass.capacity = most_rays();
    const Wave next = packed(wave.bounce + 1, most_rays());
    pass.next_count = list_count(next);
    pass.spawned_rays = at("rays", next.bounce);
    pass.spawned_weights = weights(next);
    pass.spawned_skip = skip();
    return pass;
}

rsh_spawn_desc FrameMemory::spawn_shadow(const Wave& wave, cl_uint light) const {
    rsh_spawn_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.scene = desc_.scene;
    pass.kind = RSH_SPAWN_SHADOW;
    pass.light = light;
    pass.ray_count = wave.rays();
    pass.rays = at("rays", wave.bounce);
    pass.hits = at("hits", wave.bounce);
    pass.active_count = active_count();
    pass.list_count = list_count(wave);
    pass.spawned_rays = scratch_["shadow rays"];
    pass.spawned_skip = skip();
    return pass;
}

LightPass FrameMemory::light(const Wave& wave, cl_uint light, bool is_base) const {
    return {shade(wave), spawn_shadow(wave, light), scratch_["light colour"], is_base,
            wave.bounce > 0};
}

rsh_build_desc FrameMemory::build_shadow(const Wave& wave, cl_uint light) const {
    rsh_build_desc pass = build(wave);
    pass.rays = scratch_["shadow rays"];
    pass.converging = desc_.scene->positional_lights >> light & 1;
    return pass;
}

template <class Pass>
Pass FrameMemory::of_shadow(Pass pass, cl_uint light) const {
    pass.rays = scratch_["shadow rays"];
    pass.query = RSH_QUERY_ANY;
    pass.hits = nullptr;
    pass.occlusion = occlusion();
    pass.occlusion_bit = light;
    pass.skip = skip();
    return pass;
}

rsh_traverse_desc FrameMemory::traverse_shadow(const Wave& wave, cl_uint light) const {
    return of_shadow(traverse(wave), light);
}

rsh_audit_desc FrameMemory::audit_shadow(const Wave& wave, cl_uint light) const {
    return of_shadow(audit(wave), light);
}

}  // namespace rsh
