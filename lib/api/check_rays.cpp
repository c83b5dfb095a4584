// check_rays.cpp - calls over given rays: build, traverse, spawn, shade.
#include "api/check_fields.hpp"
#include "rays/bound.hpp"
#include "rays/levels.hpp"
#include "reduce/strategy.hpp"
#include "traverse/engine.hpp"

namespace rsh {
namespace {

// A grid, or a list when height is 0 or 1.
void check_ray_grid(cl_uint width, cl_uint height) {
    if (height <= 1) {
        require(width <= kMaxRays, "width", width, "at most " + std::to_string(kMaxRays));
        return;
    }
    require(width >= 1 && width <= kMaxSide, "width", width,
            "1 .. " + std::to_string(kMaxSide) + " in a grid");
    require(height <= kMaxSide, "height", height, "at most " + std::to_string(kMaxSide));
}

void check_ray_count(cl_uint ray_count) {
    require(ray_count <= kMaxRays, "ray_count", ray_count,
            "at most " + std::to_string(kMaxRays));
}

void check_hit_rays(const Context& context, cl_uint ray_count, cl_mem rays, cl_mem hits) {
    check_buffer(context, "rays", rays, cl_ulong{ray_count} * sizeof(rsh_ray));
    check_buffer(context, "hits", hits, cl_ulong{ray_count} * sizeof(rsh_hit));
}

}  // namespace

void check_shape(const rsh_build_desc& desc) {
    check_ray_grid(desc.width, desc.height);
    require(desc.converging <= 1, "converging", desc.converging, "0 or 1");
    find_bound(desc.bound);
}

void check_buffers(const Context& context, const rsh_build_desc& desc) {
    const Bound& bound = find_bound(desc.bound);
    check_buffer(context, "rays", desc.rays,
                 ray_count(desc.width, desc.height) * sizeof(rsh_ray));
    const rsh_levels levels = bound.levels(desc.width, desc.height);
    check_buffer(context, "nodes", desc.nodes, bound.node_bytes(levels));
    check_scratch(context, desc.scratch, bound.build_scratch(context, levels).bytes());
}

void check_shape(const rsh_traverse_desc& desc) {
    check_shape(desc.geometry);
    check_ray_grid(desc.width, desc.height);
    check_bound(find_engine(desc.engine), desc.bound);
    find_strategy(desc.strategy);
    require(desc.query == RSH_QUERY_CLOSEST || desc.query == RSH_QUERY_ANY, "query", desc.query,
            "RSH_QUERY_CLOSEST or RSH_QUERY_ANY");
    if (desc.query == RSH_QUERY_ANY)
        require(desc.occlusion_bit < 32, "occlusion_bit", desc.occlusion_bit, "0 .. 31");
    check_budget(desc.budget);
}

void check_buffers(const Context& context, const rsh_traverse_desc& desc) {
    check_buffers(context, desc.geometry);
    const cl_ulong rays = ray_count(desc.width, desc.height);
    const Engine& engine = find_engine(desc.engine);
    check_buffer(context, "rays", desc.rays, rays * sizeof(rsh_ray));
    if (!engine.bounds().empty()) {
        const Bound& bound = find_bound(desc.bound);
        check_optional(context, "bounds", desc.bounds, bound.scene_bytes(desc.geometry));
        check_buffer(context, "nodes", desc.nodes,
                     bound.node_bytes(bound.levels(desc.width, desc.height)));
    }
    if (desc.query == RSH_QUERY_ANY)
        check_buffer(context, "occlusion", desc.occlusion, rays * 4);
    else
        check_buffer(context, "hits", desc.hits, rays * sizeof(rsh_hit));
    check_scratch(context, desc.scratch,
                  engine.scratch(context, desc, scene_bounds_of(desc)).bytes());
}

void check_shape(const rsh_spawn_desc& desc) {
    check_shape(*desc.scene);
    require(desc.kind <= RSH_SPAWN_SHADOW, "kind", desc.kind, "RSH_SPAWN_...");
    check_ray_count(desc.ray_count);
    if (desc.kind == RSH_SPAWN_SHADOW)
        require(desc.light < desc.scene->light_count, "light", desc.light,
                "below scene.light_count = " + std::to_string(desc.scene->light_count));
    else
        check_min_weight(desc.min_weight);
}

void check_buffers(const Context& context, const rsh_spawn_desc& desc) {
    check_buffers(context, *desc.scene);
    check_hit_rays(context, desc.ray_count, desc.rays, desc.hits);
    const cl_ulong rays = desc.ray_count;
    check_buffer(context, "spawned_rays", desc.spawned_rays, rays * sizeof(rsh_ray));
    check_optional(context, "active_count", desc.active_count, 4);
    if (desc.kind == RSH_SPAWN_SHADOW) return;
    check_optional(context, "weights", desc.weights, rays * 16);
    check_buffer(context, "spawned_weights", desc.spawned_weights, rays * 16);
}

void check_shape(const rsh_shade_desc& desc) {
    check_shape(*desc.scene);
    check_ray_count(desc.ray_count);
}

void check_buffers(const Context& context, const rsh_shade_desc& desc) {
    check_buffers(context, *desc.scene);
    check_hit_rays(context, desc.ray_count, desc.rays, desc.hits);
    const cl_ulong rays = desc.ray_count;
    check_optional(context, "weights", desc.weights, rays * 16);
    check_optional(context, "occlusion", desc.occlusion, rays * 4);
    check_buffer(context, "colour", desc.colour, rays * 16);
}

}  // namespace rsh
