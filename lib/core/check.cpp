#include "core/check.hpp"

#include <cmath>

#include "engines/engine.hpp"
#include "passes/build.hpp"
#include "passes/rasterize.hpp"
#include "pipeline.hpp"
#include "reduce/strategy.hpp"

namespace rsh {
namespace {

constexpr cl_uint kMaxTriangles = 1u << 28;
constexpr cl_uint kMaxSide = 16384;
constexpr cl_uint kMaxList = 1u << 28;

// Saturates: no offset wraps round to a small size.
cl_ulong end_of(cl_ulong offset, cl_ulong bytes) {
    return offset > ~cl_ulong{0} - bytes ? ~cl_ulong{0} : offset + bytes;
}

void check_side(const char* field, cl_uint side) {
    require(side >= 1 && side <= kMaxSide, field, side, "1 .. " + std::to_string(kMaxSide));
}


bool is_zero(const rsh_float4& v) { return v.s[0] == 0 && v.s[1] == 0 && v.s[2] == 0; }

void check_vector(const char* field, const rsh_float4& v) {
    for (int i = 0; i < 3; ++i) require(std::isfinite(v.s[i]), field, v.s[i], "finite");
}

void check_camera(const rsh_camera& camera) {
    check_vector("camera.eye", camera.eye);
    check_vector("camera.forward", camera.forward);
    check_vector("camera.right", camera.right);
    check_vector("camera.up", camera.up);
    require(!is_zero(camera.forward), "camera.forward", 0, "a direction");
    require(!is_zero(camera.right), "camera.right", 0, "a direction");
    require(!is_zero(camera.up), "camera.up", 0, "a direction");
    const float near = camera.eye.s[3], far = camera.forward.s[3];
    require(near >= 0 && std::isfinite(near), "camera.eye.w (near)", near, "finite, not negative");
    require(far == 0 || far > near, "camera.forward.w (far)", far, "0 or above near");
}

void check_images(const Context& context, const rsh_scene& scene) {
    check_buffer(context, "scene.textures", scene.textures,
                 cl_ulong{scene.texture_count} * sizeof(rsh_texture));
    if (scene.texture_count) check_buffer(context, "scene.texels", scene.texels, 4);
    require(scene.environment_texture <= scene.texture_count, "scene.environment_texture",
            scene.environment_texture, "at most scene.texture_count");
    if (scene.features & RSH_FEATURE_TEXTURE) {
        require(scene.texture_count > 0, "scene.texture_count", scene.texture_count,
                "at least 1 with RSH_FEATURE_TEXTURE");
        require_not_null(scene.texcoords, "scene.texcoords");
    }
    if (scene.features & RSH_FEATURE_ENVIRONMENT_IMAGE)
        require(scene.environment_texture > 0, "scene.environment_texture",
                scene.environment_texture, "at least 1 with RSH_FEATURE_ENVIRONMENT_IMAGE");
}

void check_hit_rays(const Context& context, cl_uint ray_count, cl_mem rays, cl_mem hits) {
    check_buffer(context, "rays", rays, cl_ulong{ray_count} * sizeof(rsh_ray));
    check_buffer(context, "hits", hits, cl_ulong{ray_count} * sizeof(rsh_hit));
}

void check_optional(const Context& context, const char* field, cl_mem buffer, cl_ulong bytes) {
    if (buffer) check_buffer(context, field, buffer, bytes);
}

}  // namespace

void require_not_null(const void* pointer, const char* field) {
    if (!pointer) throw Error(RSH_INVALID_VALUE, std::string(field) + ": is NULL, must not be");
}

Context& checked_context(rsh_context context) {
    require_not_null(context, "context");
    return *context;
}

void check_submission(const Context& context, cl_command_queue queue, cl_uint wait_count,
                      const cl_event* wait_list) {
    require_not_null(queue, "queue");
    const cl::CommandQueue wrapped(queue, true);
    if (wrapped.getInfo<CL_QUEUE_CONTEXT>()() != context.cl() ||
        wrapped.getInfo<CL_QUEUE_DEVICE>()() != context.device())
        throw Error(RSH_INVALID_VALUE,
                    "queue: is of another context or device, must be of the rsh_context's");
    require((wait_count == 0) == (wait_list == nullptr), "wait_count", wait_count,
            wait_list ? "above 0 with a wait_list" : "0 without a wait_list");
    for (cl_uint i = 0; i < wait_count; ++i) require_not_null(wait_list[i], "wait_list[i]");
}

void check_buffer(const Context& context, const char* field, cl_mem buffer, cl_ulong bytes) {
    if (bytes == 0 && !buffer) return;
    require_not_null(buffer, field);
    const cl::Buffer wrapped(buffer, true);
    if (wrapped.getInfo<CL_MEM_CONTEXT>()() != context.cl())
        throw Error(RSH_INVALID_VALUE, std::string(field) +
                                           ": is of another cl_context, must be of the "
                                           "rsh_context's");
    const cl_ulong actual = wrapped.getInfo<CL_MEM_SIZE>();
    if (actual < bytes)
        throw Error(RSH_BUFFER_TOO_SMALL, std::string(field) + ": holds " +
                                              std::to_string(actual) + " bytes, needs " +
                                              std::to_string(bytes));
}

void check_scratch(const Context& context, cl_mem scratch, size_t bytes) {
    if (scratch) check_buffer(context, "scratch", scratch, bytes);
    if (bytes > context.caps.max_allocation)
        throw Error(RSH_UNSUPPORTED, "scratch: needs " + std::to_string(bytes) +
                                         " bytes, the device allocates at most " +
                                         std::to_string(context.caps.max_allocation));
}

void check(const Context& context, const rsh_geometry& geometry) {
    require(geometry.triangle_count < kMaxTriangles, "geometry.triangle_count",
            geometry.triangle_count, "below " + std::to_string(kMaxTriangles));
    const cl_ulong stride = geometry.vertex_stride ? geometry.vertex_stride : 12;
    require(stride >= 12 && stride % 4 == 0, "geometry.vertex_stride", stride,
            "0 or a multiple of 4, at least 12");
    require(geometry.vertices_offset % 4 == 0, "geometry.vertices_offset",
            geometry.vertices_offset, "a multiple of 4");
    require(geometry.indices_offset % 4 == 0, "geometry.indices_offset", geometry.indices_offset,
            "a multiple of 4");
    const cl_ulong vertices = geometry.vertex_count;
    check_buffer(context, "geometry.vertices", geometry.vertices,
                 vertices ? end_of(geometry.vertices_offset, (vertices - 1) * stride + 12) : 0);
    if (geometry.indices)
        check_buffer(context, "geometry.indices", geometry.indices,
                     end_of(geometry.indices_offset, cl_ulong{geometry.triangle_count} * 12));
}

void check(const Context& context, const rsh_scene* scene) {
    require_not_null(scene, "scene");
    require(scene->struct_size == sizeof(rsh_scene), "scene.struct_size", scene->struct_size,
            std::to_string(sizeof(rsh_scene)));
    check(context, scene->geometry);
    const cl_ulong vertices = scene->geometry.vertex_count;
    check_optional(context, "scene.normals", scene->normals, vertices * 12);
    check_optional(context, "scene.texcoords", scene->texcoords, vertices * 8);
    check_optional(context, "scene.material_ids", scene->material_ids,
                   cl_ulong{scene->geometry.triangle_count} * 4);
    require(scene->material_count >= 1, "scene.material_count", scene->material_count,
            "at least 1");
    check_buffer(context, "scene.materials", scene->materials,
                 cl_ulong{scene->material_count} * sizeof(rsh_material));
    require(scene->light_count <= RSH_MAX_LIGHTS, "scene.light_count", scene->light_count,
            "at most " + std::to_string(RSH_MAX_LIGHTS));
    check_buffer(context, "scene.lights", scene->lights,
                 cl_ulong{scene->light_count} * sizeof(rsh_light));
    require((scene->features & ~RSH_FEATURE_ALL) == 0, "scene.features", scene->features,
            "made of RSH_FEATURE_ bits");
    if (scene->features & RSH_FEATURE_SMOOTH_NORMAL)
        require_not_null(scene->normals, "scene.normals");
    check_images(context, *scene);
    check_vector("scene.ambient", scene->ambient);
    check_vector("scene.environment", scene->environment);
}

void check(const Context& context, const rsh_rasterize_desc& desc) {
    check(context, desc.geometry);
    check_camera(desc.camera);
    check_side("width", desc.width);
    check_side("height", desc.height);
    const cl_ulong pixels = cl_ulong{desc.width} * desc.height;
    check_buffer(context, "rays", desc.rays, pixels * sizeof(rsh_ray));
    check_buffer(context, "hits", desc.hits, pixels * sizeof(rsh_hit));
    check_scratch(context, desc.scratch, rasterize_scratch(context, desc).bytes());
}

void check(const Context& context, const rsh_bound_desc& desc) {
    check(context, desc.geometry);
    check_buffer(context, "spheres", desc.spheres, cl_ulong{desc.geometry.triangle_count} * 16);
}

void check_ray_grid(cl_uint width, cl_uint height) {
    if (height <= 1) {
        require(width <= kMaxList, "width", width, "at most " + std::to_string(kMaxList));
        return;
    }
    require(width >= 1 && width <= kMaxSide, "width", width,
            "1 .. " + std::to_string(kMaxSide) + " in a grid");
    require(height <= kMaxSide, "height", height, "at most " + std::to_string(kMaxSide));
}

void check(const Context& context, const rsh_build_desc& desc) {
    check_ray_grid(desc.width, desc.height);
    require(desc.converging <= 1, "converging", desc.converging, "0 or 1");
    const rsh_levels levels = levels_of(desc.width, desc.height);
    check_buffer(context, "rays", desc.rays, ray_count(levels) * sizeof(rsh_ray));
    check_buffer(context, "nodes", desc.nodes, node_bytes(levels));
}

void check(const Context& context, const rsh_traverse_desc& desc) {
    check(context, desc.geometry);
    check_ray_grid(desc.width, desc.height);
    const rsh_levels levels = levels_of(desc.width, desc.height);
    const cl_ulong rays = ray_count(levels);
    check_buffer(context, "rays", desc.rays, rays * sizeof(rsh_ray));
    check_optional(context, "spheres", desc.spheres, cl_ulong{desc.geometry.triangle_count} * 16);
    const Engine& engine = find_engine(desc.engine);
    if (engine.needs_nodes()) check_buffer(context, "nodes", desc.nodes, node_bytes(levels));
    find_strategy(desc.strategy);
    require(desc.query == RSH_QUERY_CLOSEST || desc.query == RSH_QUERY_ANY, "query", desc.query,
            "RSH_QUERY_CLOSEST or RSH_QUERY_ANY");
    if (desc.query == RSH_QUERY_ANY) {
        check_buffer(context, "occlusion", desc.occlusion, rays * 4);
        require(desc.occlusion_bit < 32, "occlusion_bit", desc.occlusion_bit, "0 .. 31");
    } else {
        check_buffer(context, "hits", desc.hits, rays * sizeof(rsh_hit));
    }
    require(desc.budget == 0 || desc.budget >= RSH_MIN_BUDGET, "budget", desc.budget,
            "0 or at least " + std::to_string(RSH_MIN_BUDGET));
    check_scratch(context, desc.scratch, engine.scratch(context, desc, spheres_of(desc)).bytes());
}

void check(const Context& context, const rsh_spawn_desc& desc) {
    check(context, desc.scene);
    require(desc.kind <= RSH_SPAWN_SHADOW, "kind", desc.kind, "RSH_SPAWN_...");
    check_hit_rays(context, desc.ray_count, desc.rays, desc.hits);
    const cl_ulong rays = desc.ray_count;
    check_buffer(context, "spawned_rays", desc.spawned_rays, rays * sizeof(rsh_ray));
    check_optional(context, "active_count", desc.active_count, 4);
    if (desc.kind == RSH_SPAWN_SHADOW) {
        require(desc.light < desc.scene->light_count, "light", desc.light,
                "below scene.light_count = " + std::to_string(desc.scene->light_count));
        return;
    }
    require(desc.min_weight >= 0 && std::isfinite(desc.min_weight), "min_weight", desc.min_weight,
            "finite, not negative");
    check_optional(context, "weights", desc.weights, rays * 16);
    check_buffer(context, "spawned_weights", desc.spawned_weights, rays * 16);
}

void check(const Context& context, const rsh_shade_desc& desc) {
    check(context, desc.scene);
    check_hit_rays(context, desc.ray_count, desc.rays, desc.hits);
    const cl_ulong rays = desc.ray_count;
    check_optional(context, "weights", desc.weights, rays * 16);
    check_optional(context, "occlusion", desc.occlusion, rays * 4);
    check_buffer(context, "colour", desc.colour, rays * 16);
}

void check(const Context& context, const rsh_frame_desc& desc) {
    check(context, desc.scene);
    check_camera(desc.camera);
    check_side("width", desc.width);
    check_side("height", desc.height);
    require(desc.bounces <= RSH_MAX_LEVELS, "bounces", desc.bounces,
            "at most " + std::to_string(RSH_MAX_LEVELS));
    require(desc.min_weight >= 0 && std::isfinite(desc.min_weight), "min_weight", desc.min_weight,
            "finite, not negative");
    find_engine(desc.engine);
    find_strategy(desc.strategy);
    require(desc.budget == 0 || desc.budget >= RSH_MIN_BUDGET, "budget", desc.budget,
            "0 or at least " + std::to_string(RSH_MIN_BUDGET));
    check_buffer(context, "colour", desc.colour, cl_ulong{desc.width} * desc.height * 16);
    check_scratch(context, desc.scratch, frame_scratch(context, desc).bytes());
}

void check(const Context& context, const rsh_reduce_desc& desc) {
    find_strategy(desc.strategy);
    require(desc.keep <= RSH_KEEP_NOT_NULL, "keep", desc.keep, "RSH_KEEP_...");
    const cl_ulong bytes = desc.element_bytes;
    require(bytes == 4 || bytes == 8 || bytes == 12 || bytes == 16, "element_bytes", bytes,
            "4, 8, 12 or 16");
    check_optional(context, "input_count", desc.input_count, 4);
    check_buffer(context, "input", desc.input, desc.count * bytes);
    if (desc.keep == RSH_KEEP_FLAGS) check_buffer(context, "flags", desc.flags, desc.count);
    check_buffer(context, "output", desc.output, desc.count ? bytes : 0);
    check_buffer(context, "output_count", desc.output_count, 4);
    check_scratch(context, desc.scratch, reduce_scratch(context, desc).bytes());
}

}  // namespace rsh
