#include "frame/memory.hpp"

#include <algorithm>

#include "camera/rasterize.hpp"
#include "device/cl/span.hpp"
#include "frame/passes.hpp"
#include "frame/strips.hpp"

namespace rsh {

FrameMemory::FrameMemory(Recorder& recorder, const rsh_frame_desc& desc)
    : whole_(desc),
      size_(strip_size(recorder.context(), desc)),
      desc_(desc),
      scratch_(recorder, strip_scratch(recorder.context(), desc, size_), desc.scratch) {
    for (cl_uint bounce = 0; is_in_batches() && bounce <= (has_bounces() ? desc.bounces : 0);
         ++bounce)
        seen_scenes_.push_back(scene_of(*desc.scene, seen(bounce)));
}

bool FrameMemory::take_strip(cl_uint first_row) {
    if (first_row >= whole_.height) return false;
    desc_.height = std::min(size_.rows, whole_.height - first_row);
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

const rsh_scene* FrameMemory::scene(cl_uint bounce) const {
    return is_in_batches() ? &seen_scenes_[bounce] : desc_.scene;
}

cl_mem FrameMemory::bounds() const {
    return desc_.bounds ? desc_.bounds : scratch_.find("bounds");
}

bool FrameMemory::traces_rays() const {
    return needs_traversals(desc_);
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
    return wave.bounce > 0 ? leaving(pass, wave.bounce - 1) : pass;
}

rsh_traverse_desc FrameMemory::leaving(rsh_traverse_desc pass, cl_uint bounce) const {
    if (!is_in_batches()) return pass;
    const SeenTriangles left = seen(bounce);
    pass.skip_corners = left.corners;
    pass.skip_numbers = left.numbers;
    pass.skip_count = left.count;
    return pass;
}

rsh_build_desc FrameMemory::build_screen() const {
    rsh_build_desc pass = build(screen());
    pass.rays = pixels().screen_rays;
    return pass;
}

rsh_traverse_desc FrameMemory::traverse_screen() const {
    const PixelPass all = pixels();
    rsh_traverse_desc pass = traverse_of(desc_, desc_.width, desc_.height);
    pass.rays = all.screen_rays;
    pass.nodes = scratch_["nodes"];
    pass.hits = all.screen_hits;
    pass.scratch = scratch_["traverse"];
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
    return {scene(0),        grid_of(desc_.width, desc_.height, step),
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
    pass.scene = scene(wave.bounce);
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
    pass.scene = scene(wave.bounce);
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
    pass.scene = scene(wave.bounce);
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
    return leaving(of_shadow(traverse(wave), light), wave.bounce);
}

rsh_audit_desc FrameMemory::audit_shadow(const Wave& wave, cl_uint light) const {
    return of_shadow(audit(wave), light);
}

}  // namespace rsh
