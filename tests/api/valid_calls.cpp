// valid_calls.cpp - the descriptors, and the look at all outputs.
#include "api/valid_calls.hpp"

namespace test {
namespace {

template <class Desc>
Desc empty() {
    Desc desc = {};
    desc.struct_size = sizeof desc;
    return desc;
}

}  // namespace

rsh_rasterize_desc ValidCalls::rasterize() const {
    auto desc = empty<rsh_rasterize_desc>();
    desc.geometry = scene.desc.geometry;
    desc.camera = gallery_camera(kSide, kSide);
    desc.width = desc.height = kSide;
    desc.rays = out_rays.get();
    desc.hits = hits.get();
    return desc;
}

rsh_bound_desc ValidCalls::bound() const {
    auto desc = empty<rsh_bound_desc>();
    desc.geometry = scene.desc.geometry;
    desc.bounds = bounds.get();
    return desc;
}

rsh_build_desc ValidCalls::build() const {
    auto desc = empty<rsh_build_desc>();
    desc.rays = rays.get();
    desc.width = desc.height = kSide;
    desc.nodes = nodes.get();
    return desc;
}

rsh_traverse_desc ValidCalls::traverse() const {
    auto desc = empty<rsh_traverse_desc>();
    desc.geometry = scene.desc.geometry;
    desc.rays = rays.get();
    desc.width = desc.height = kSide;
    desc.hits = hits.get();
    desc.engine = RSH_ENGINE_BRUTE_FORCE;
    return desc;
}

rsh_trace_desc ValidCalls::trace() const {
    auto desc = empty<rsh_trace_desc>();
    desc.geometry = scene.desc.geometry;
    desc.rays = rays.get();
    desc.width = desc.height = kSide;
    desc.hits = hits.get();
    desc.engine = RSH_ENGINE_BRUTE_FORCE;
    return desc;
}

rsh_trace_desc ValidCalls::trace_batches() const {
    rsh_trace_desc desc = trace();
    desc.geometry = {};
    desc.engine = RSH_ENGINE_TILES;
    desc.batches = source.get();
    return desc;
}

rsh_frame_desc ValidCalls::frame_batches() const {
    rsh_frame_desc desc = frame();
    desc.scene = &batched;
    desc.bounces = 1;
    desc.batches = source.get();
    return desc;
}

rsh_scene ValidCalls::scene_of_batches() const {
    rsh_scene desc = scene.desc;
    leave_to_batches(desc);
    return desc;
}

rsh_audit_desc ValidCalls::audit() const {
    auto desc = empty<rsh_audit_desc>();
    desc.geometry = scene.desc.geometry;
    desc.ray_count = kRays;
    desc.rays = rays.get();
    desc.hits = in_hits.get();
    desc.report = report.get();
    return desc;
}

rsh_spawn_desc ValidCalls::spawn() const {
    auto desc = empty<rsh_spawn_desc>();
    desc.scene = &scene.desc;
    desc.ray_count = kRays;
    desc.rays = rays.get();
    desc.hits = in_hits.get();
    desc.spawned_rays = out_rays.get();
    desc.spawned_weights = weights.get();
    return desc;
}

rsh_spawn_wave_desc ValidCalls::spawn_wave() const {
    auto desc = empty<rsh_spawn_wave_desc>();
    desc.scene = &scene.desc;
    desc.width = desc.height = kSide;
    desc.rays = rays.get();
    desc.hits = in_hits.get();
    desc.capacity = kRays;
    desc.branches = branches.get();
    desc.spawned_rays = out_rays.get();
    desc.spawned_weights = weights.get();
    desc.spawned_skip = occlusion.get();
    desc.spawned_count = spawned_count.get();
    return desc;
}

rsh_gather_wave_desc ValidCalls::gather_wave() const {
    auto desc = empty<rsh_gather_wave_desc>();
    desc.scene = &scene.desc;
    desc.width = desc.height = kSide;
    desc.capacity = kRays;
    desc.branches = in_branches.get();
    desc.spawned_count = in_spawned_count.get();
    desc.spawned_colour = weights.get();
    desc.colour = colour.get();
    return desc;
}

rsh_shadow_desc ValidCalls::shadow() const {
    auto desc = empty<rsh_shadow_desc>();
    desc.scene = &scene.desc;
    desc.width = desc.height = kSide;
    desc.rays = rays.get();
    desc.hits = in_hits.get();
    desc.occlusion = occlusion.get();
    return desc;
}

rsh_find_surfaces_desc ValidCalls::find_surfaces() const {
    auto desc = empty<rsh_find_surfaces_desc>();
    desc.scene = &scene.desc;
    desc.ray_count = kRays;
    desc.rays = rays.get();
    desc.hits = in_hits.get();
    desc.surfaces = surfaces.get();
    return desc;
}

rsh_shade_desc ValidCalls::shade() const {
    auto desc = empty<rsh_shade_desc>();
    desc.scene = &scene.desc;
    desc.ray_count = kRays;
    desc.rays = rays.get();
    desc.hits = in_hits.get();
    desc.colour = colour.get();
    return desc;
}

rsh_frame_desc ValidCalls::frame() const {
    auto desc = empty<rsh_frame_desc>();
    desc.scene = &scene.desc;
    desc.camera = gallery_camera(kSide, kSide);
    desc.width = desc.height = kSide;
    desc.colour = colour.get();
    return desc;
}

rsh_reduce_desc ValidCalls::reduce() const {
    auto desc = empty<rsh_reduce_desc>();
    desc.element_bytes = 4;
    desc.count = 1024;
    desc.input = words.get();
    desc.flags = flags.get();
    desc.output = packed.get();
    desc.output_count = count.get();
    return desc;
}

::testing::AssertionResult ValidCalls::outputs_untouched() const {
    device().queue.finish();
    const ::testing::AssertionResult results[] = {
        out_rays.untouched(),     hits.untouched(),     occlusion.untouched(),
        colour.untouched(),       weights.untouched(),  bounds.untouched(),
        nodes.untouched(),        packed.untouched(),   count.untouched(),
        report.untouched(),       surfaces.untouched(), branches.untouched(),
        spawned_count.untouched()};
    const char* const names[] = {"rays",     "hits",     "occlusion",    "colour", "weights",
                                 "bounds",   "nodes",    "packed",       "count",  "report",
                                 "surfaces", "branches", "spawned_count"};
    for (size_t i = 0; i < std::size(results); ++i)
        if (!results[i])
            return ::testing::AssertionFailure() << names[i] << ": " << results[i].message();
    return ::testing::AssertionSuccess();
}

}  // namespace test
