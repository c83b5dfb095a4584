// check_scene.cpp - triangles, materials, lights and images.
#include "api/check_fields.hpp"
#include "rays/bound.hpp"

namespace rsh {
namespace {

constexpr cl_uint kMaxTriangles = 1u << 28;

// Saturates: no offset wraps round to a small size.
cl_ulong end_of(cl_ulong offset, cl_ulong bytes) {
    return offset > ~cl_ulong{0} - bytes ? ~cl_ulong{0} : offset + bytes;
}

cl_ulong stride_of(const rsh_geometry& geometry) {
    return geometry.vertex_stride ? geometry.vertex_stride : 12;
}

void check_images(const rsh_scene& scene) {
    require(scene.environment_texture <= scene.texture_count, "scene.environment_texture",
            scene.environment_texture, "at most scene.texture_count");
    if (scene.features & RSH_FEATURE_TEXTURE)
        require(scene.texture_count > 0, "scene.texture_count", scene.texture_count,
                "at least 1 with RSH_FEATURE_TEXTURE");
    if (scene.features & RSH_FEATURE_ENVIRONMENT_IMAGE)
        require(scene.environment_texture > 0, "scene.environment_texture",
                scene.environment_texture, "at least 1 with RSH_FEATURE_ENVIRONMENT_IMAGE");
}

void check_image_buffers(const Context& context, const rsh_scene& scene) {
    check_buffer(context, "scene.textures", scene.textures,
                 cl_ulong{scene.texture_count} * sizeof(rsh_texture));
    if (scene.texture_count) check_buffer(context, "scene.texels", scene.texels, 4);
    if (scene.features & RSH_FEATURE_TEXTURE)
        require_not_null(scene.texcoords, "scene.texcoords");
}

}  // namespace

void check_shape(const rsh_geometry& geometry) {
    require(geometry.triangle_count < kMaxTriangles, "geometry.triangle_count",
            geometry.triangle_count, "below " + std::to_string(kMaxTriangles));
    const cl_ulong stride = stride_of(geometry);
    require(stride >= 12 && stride % 4 == 0, "geometry.vertex_stride", stride,
            "0 or a multiple of 4, at least 12");
    require(geometry.vertices_offset % 4 == 0, "geometry.vertices_offset",
            geometry.vertices_offset, "a multiple of 4");
    require(geometry.indices_offset % 4 == 0, "geometry.indices_offset",
            geometry.indices_offset, "a multiple of 4");
}

void check_buffers(const Context& context, const rsh_geometry& geometry) {
    const cl_ulong vertices = geometry.vertex_count, stride = stride_of(geometry);
    check_buffer(context, "geometry.vertices", geometry.vertices,
                 vertices ? end_of(geometry.vertices_offset, (vertices - 1) * stride + 12) : 0);
    check_optional(context, "geometry.indices", geometry.indices,
                   end_of(geometry.indices_offset, cl_ulong{geometry.triangle_count} * 12));
}

void check_shape(const rsh_scene& scene) {
    check_shape(scene.geometry);
    require(scene.material_count >= 1, "scene.material_count", scene.material_count,
            "at least 1");
    require(scene.light_count <= RSH_MAX_LIGHTS, "scene.light_count", scene.light_count,
            "at most " + std::to_string(RSH_MAX_LIGHTS));
    require((scene.features & ~RSH_FEATURE_ALL) == 0, "scene.features", scene.features,
            "made of RSH_FEATURE_ bits");
    check_images(scene);
    check_vector("scene.ambient", scene.ambient);
    check_vector("scene.environment", scene.environment);
}

void check_buffers(const Context& context, const rsh_scene& scene) {
    check_buffers(context, scene.geometry);
    const cl_ulong vertices = scene.geometry.vertex_count;
    check_optional(context, "scene.normals", scene.normals, vertices * 12);
    check_optional(context, "scene.texcoords", scene.texcoords, vertices * 8);
    check_optional(context, "scene.material_ids", scene.material_ids,
                   cl_ulong{scene.geometry.triangle_count} * 4);
    check_buffer(context, "scene.materials", scene.materials,
                 cl_ulong{scene.material_count} * sizeof(rsh_material));
    check_buffer(context, "scene.lights", scene.lights,
                 cl_ulong{scene.light_count} * sizeof(rsh_light));
    if (scene.features & RSH_FEATURE_SMOOTH_NORMAL)
        require_not_null(scene.normals, "scene.normals");
    check_image_buffers(context, scene);
}

void check_shape(const rsh_bound_desc& desc) {
    check_shape(desc.geometry);
    find_bound(desc.bound);
    require(desc.update <= RSH_UPDATE_FIRST, "update", desc.update, "an RSH_UPDATE_... value");
}

void check_buffers(const Context& context, const rsh_bound_desc& desc) {
    check_buffers(context, desc.geometry);
    check_buffer(context, "bounds", desc.bounds,
                 find_bound(desc.bound).scene_bytes(desc.geometry));
    check_scratch(
        context, desc.scratch,
        find_bound(desc.bound).bound_scratch(context, desc.geometry, desc.update).bytes());
}

}  // namespace rsh
