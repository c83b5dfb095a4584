// check_rays.cpp - calls over given rays: build, traverse, spawn, shadow,
// surfaces, shade.
#include "api/check_fields.hpp"
#include "bvh/scene_bounds.hpp"
#include "rays/levels.hpp"
#include "rays/node_shape.hpp"
#include "reduce/strategy.hpp"
#include "shadow/shadow.hpp"
#include "traverse/engine.hpp"
#include "traverse/list_hits.hpp"

namespace rsh {
namespace {

void check_ray_count(cl_uint ray_count) {
    require(ray_count <= kMaxRays, "ray_count", ray_count, "at most ", kMaxRays);
}

void check_cull(cl_uint cull) {
    require(cull <= RSH_CULL_FRONT, "cull", cull, "an RSH_CULL_... value");
}

template <class Desc>
void check_query(const Desc& desc) {
    require(desc.query <= RSH_QUERY_ALL, "query", desc.query, "RSH_QUERY_...");
    if (desc.query == RSH_QUERY_ANY)
        require(desc.occlusion_bit < 32, "occlusion_bit", desc.occlusion_bit, "0 .. 31");
    if (desc.query == RSH_QUERY_ALL)
        require(desc.hit_capacity <= kMaxHits, "hit_capacity", desc.hit_capacity, "at most ",
                kMaxHits);
}

// Triangles that are a batch of a scene, see rsh_traverse.
void check_batch(const rsh_traverse_desc& desc) {
    require(desc.continued <= 1, "continued", desc.continued, "0 or 1");
    const cl_uint most = RSH_NO_HIT - 1 - desc.geometry.triangle_count;
    require(desc.first_triangle <= most, "first_triangle", desc.first_triangle, "at most ",
            most, " with that many triangles");
    require(desc.skip_count <= kMaxRays, "skip_count", desc.skip_count, "at most ", kMaxRays);
    if (desc.continued || desc.first_triangle)
        require(desc.query <= RSH_QUERY_ANY, "query", desc.query,
                "RSH_QUERY_CLOSEST or RSH_QUERY_ANY with continued or first_triangle");
}

void check_hit_rays(Buffers& buffers, cl_uint ray_count, cl_mem rays, cl_mem hits) {
    buffers.in("rays", rays, cl_ulong{ray_count} * sizeof(rsh_ray));
    buffers.in("hits", hits, cl_ulong{ray_count} * sizeof(rsh_hit));
}

}  // namespace

void check_shape(const rsh_build_desc& desc) {
    check_ray_grid(desc.width, desc.height);
    require(desc.converging <= 1, "converging", desc.converging, "0 or 1");
    find_shape(desc.shape);
    check_list_count(desc);
}

void check_buffers(const Context& context, const rsh_build_desc& desc) {
    Buffers buffers(context);
    const NodeShape& shape = find_shape(desc.shape);
    buffers.in("rays", desc.rays, ray_count(desc.width, desc.height) * sizeof(rsh_ray));
    buffers.optional_in("list_count", desc.list_count, 4);
    const ray_levels levels = shape.levels(desc.width, desc.height);
    buffers.out("nodes", desc.nodes, shape.bytes(levels));
    buffers.scratch(desc.scratch, shape.scratch(context, levels).bytes());
}

void check_shape(const rsh_traverse_desc& desc) {
    check_shape(desc.geometry);
    check_ray_grid(desc.width, desc.height);
    check_node_shape(find_engine(desc.engine), desc.shape);
    find_strategy(desc.strategy);
    check_list_count(desc);
    check_query(desc);
    check_cull(desc.cull);
    check_budget(desc.budget);
    check_batch(desc);
    const Engine& engine = find_engine(desc.engine);
    require(!desc.tests_per_ray || engine.counts_tests_per_ray(), "tests_per_ray: engine",
            engine.name(), "tiles or brute_force");
}

void check_skip(Buffers& buffers, const rsh_traverse_desc& desc) {
    buffers.optional_in("skip", desc.skip, ray_count(desc.width, desc.height) * 4);
    if (!desc.skip_corners) {
        if (desc.skip && (desc.continued || desc.first_triangle))
            throw Error(RSH_INVALID_VALUE,
                        "skip_corners: is NULL, must not be with skip and a batch of a scene");
        return;
    }
    require(desc.query <= RSH_QUERY_ANY, "query", desc.query,
            "RSH_QUERY_CLOSEST or RSH_QUERY_ANY with skip_corners");
    buffers.in("skip_corners", desc.skip_corners, cl_ulong{desc.skip_count} * 36);
    buffers.in("skip_numbers", desc.skip_numbers, cl_ulong{desc.skip_count} * 4);
}

void check_answers(Buffers& buffers, const rsh_traverse_desc& desc) {
    const cl_ulong rays = ray_count(desc.width, desc.height);
    if (desc.query == RSH_QUERY_CLOSEST) buffers.out("hits", desc.hits, rays * sizeof(rsh_hit));
    if (desc.query == RSH_QUERY_ANY) buffers.out("occlusion", desc.occlusion, rays * 4);
    if (desc.query == RSH_QUERY_COUNT) buffers.out("hit_counts", desc.hit_counts, rays * 4);
    if (desc.query != RSH_QUERY_ALL) return;
    buffers.out("hit_offsets", desc.hit_offsets, (rays + 1) * sizeof(cl_ulong));
    buffers.out("hits", desc.hits, desc.hit_capacity * sizeof(rsh_hit));
}

void check_buffers(const Context& context, const rsh_traverse_desc& desc) {
    Buffers buffers(context);
    check_buffers(buffers, desc.geometry);
    const cl_ulong rays = ray_count(desc.width, desc.height);
    const Engine& engine = find_engine(desc.engine);
    buffers.in("rays", desc.rays, rays * sizeof(rsh_ray));
    buffers.optional_in("list_count", desc.list_count, 4);
    check_skip(buffers, desc);
    buffers.optional_in("ray_masks", desc.ray_masks, rays * 4);
    buffers.optional_out("tests_per_ray", desc.tests_per_ray, rays * 4);
    if (engine.node_shape() != RSH_SHAPE_DEFAULT) {
        const NodeShape& shape = find_shape(desc.shape);
        buffers.optional_in("bounds", desc.bounds, bounds_for(desc.shape).bytes(desc.geometry));
        buffers.in("nodes", desc.nodes, shape.bytes(shape.levels(desc.width, desc.height)));
    }
    check_answers(buffers, desc);
    buffers.scratch(desc.scratch, traverse_scratch(context, desc).bytes());
}

void check_shape(const rsh_audit_desc& desc) {
    check_shape(desc.geometry);
    check_ray_count(desc.ray_count);
    check_query(desc);
    check_cull(desc.cull);
}

void check_buffers(const Context& context, const rsh_audit_desc& desc) {
    Buffers buffers(context);
    check_buffers(buffers, desc.geometry);
    const cl_ulong rays = desc.ray_count;
    buffers.in("rays", desc.rays, rays * sizeof(rsh_ray));
    buffers.optional_in("list_count", desc.list_count, 4);
    buffers.optional_in("skip", desc.skip, rays * 4);
    buffers.optional_in("ray_masks", desc.ray_masks, rays * 4);
    if (desc.query == RSH_QUERY_CLOSEST) buffers.in("hits", desc.hits, rays * sizeof(rsh_hit));
    if (desc.query == RSH_QUERY_ANY) buffers.in("occlusion", desc.occlusion, rays * 4);
    if (desc.query == RSH_QUERY_COUNT) buffers.in("hit_counts", desc.hit_counts, rays * 4);
    if (desc.query == RSH_QUERY_ALL) {
        buffers.in("hit_offsets", desc.hit_offsets, (rays + 1) * sizeof(cl_ulong));
        buffers.in("hits", desc.hits, desc.hit_capacity * sizeof(rsh_hit));
    }
    buffers.out("report", desc.report, sizeof(rsh_audit_report));
}

void check_shape(const rsh_spawn_desc& desc) {
    check_shape(*desc.scene);
    require(desc.kind <= RSH_SPAWN_SHADOW, "kind", desc.kind, "RSH_SPAWN_...");
    check_ray_count(desc.ray_count);
    if (desc.kind == RSH_SPAWN_SHADOW)
        require(desc.light < desc.scene->light_count, "light", desc.light,
                "below scene.light_count = ", desc.scene->light_count);
    else
        check_min_weight(desc.min_weight);
}

void check_buffers(const Context& context, const rsh_spawn_desc& desc) {
    Buffers buffers(context);
    check_buffers(buffers, *desc.scene);
    check_hit_rays(buffers, desc.ray_count, desc.rays, desc.hits);
    buffers.optional_in("list_count", desc.list_count, 4);
    const cl_ulong rays = desc.ray_count;
    buffers.out("spawned_rays", desc.spawned_rays, rays * sizeof(rsh_ray));
    buffers.optional_out("active_count", desc.active_count, 4);
    buffers.optional_out("spawned_skip", desc.spawned_skip, rays * 4);
    if (desc.kind == RSH_SPAWN_SHADOW) return;
    buffers.optional_in("weights", desc.weights, rays * 16);
    buffers.out("spawned_weights", desc.spawned_weights, rays * 16);
}

void check_shape(const rsh_shadow_desc& desc) {
    check_shape(*desc.scene);
    check_shape(shadow_traverse(desc));
}

void check_buffers(const Context& context, const rsh_shadow_desc& desc) {
    Buffers buffers(context);
    check_buffers(buffers, *desc.scene);
    const cl_ulong rays = ray_count(desc.width, desc.height);
    check_hit_rays(buffers, static_cast<cl_uint>(rays), desc.rays, desc.hits);
    buffers.optional_in("list_count", desc.list_count, 4);
    if (find_engine(desc.engine).node_shape() != RSH_SHAPE_DEFAULT)
        buffers.optional_in("bounds", desc.bounds,
                            bounds_for(desc.shape).bytes(desc.scene->geometry));
    buffers.out("occlusion", desc.occlusion, rays * 4);
    buffers.optional_out("active_count", desc.active_count, 4);
    buffers.scratch(desc.scratch, shadow_scratch(context, desc).bytes());
}

void check_shape(const rsh_find_surfaces_desc& desc) {
    check_shape(*desc.scene);
    check_ray_count(desc.ray_count);
}

void check_buffers(const Context& context, const rsh_find_surfaces_desc& desc) {
    Buffers buffers(context);
    check_buffers(buffers, *desc.scene);
    check_hit_rays(buffers, desc.ray_count, desc.rays, desc.hits);
    buffers.optional_in("list_count", desc.list_count, 4);
    buffers.out("surfaces", desc.surfaces, cl_ulong{desc.ray_count} * sizeof(rsh_surface));
}

void check_shape(const rsh_shade_desc& desc) {
    check_shape(*desc.scene);
    check_ray_count(desc.ray_count);
}

void check_buffers(const Context& context, const rsh_shade_desc& desc) {
    Buffers buffers(context);
    check_buffers(buffers, *desc.scene);
    check_hit_rays(buffers, desc.ray_count, desc.rays, desc.hits);
    buffers.optional_in("list_count", desc.list_count, 4);
    const cl_ulong rays = desc.ray_count;
    buffers.optional_in("weights", desc.weights, rays * 16);
    buffers.optional_in("occlusion", desc.occlusion, rays * 4);
    buffers.out("colour", desc.colour, rays * 16);
}

}  // namespace rsh
