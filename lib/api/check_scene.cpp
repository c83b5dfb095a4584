// check_scene.cpp - triangles, materials, lights and images.
#include <iterator>

#include "api/check_fields.hpp"
#include "bvh/scene_bounds.hpp"

namespace rsh {
namespace {

constexpr cl_uint kMaxTriangles = 1u << 28;
// The numbers behind them are no triangles of any batch: see kernels/mesh/batch.h.
constexpr cl_uint kMaxInBatches = 0u - kMaxTriangles;
constexpr cl_uint kBatchAttributes =
    RSH_BATCH_INDICES | RSH_BATCH_NORMALS | RSH_BATCH_TEXCOORDS | RSH_BATCH_MATERIAL_IDS;

cl_ulong stride_of(const rsh_geometry& geometry) {
    return geometry.vertex_stride ? geometry.vertex_stride : 12;
}

void check_cut(const rsh_scene& scene) {
    require(scene.cut <= RSH_CUT_ENVIRONMENT, "scene.cut", scene.cut, "an RSH_CUT_... value");
}

void check_normals(const rsh_scene& scene) {
    const cl_uint stride = scene.normal_stride;
    require(stride == 0 || (stride >= 12 && stride % 4 == 0), "scene.normal_stride", stride,
            "0 or a multiple of 4, at least 12");
    require(scene.normals_offset % 4 == 0, "scene.normals_offset", scene.normals_offset,
            "a multiple of 4");
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

void check_image_buffers(Buffers& buffers, const rsh_scene& scene) {
    buffers.in("scene.textures", scene.textures,
               cl_ulong{scene.texture_count} * sizeof(rsh_texture));
    if (scene.texture_count) buffers.in("scene.texels", scene.texels, 4);
    if (scene.features & RSH_FEATURE_TEXTURE)
        require_not_null(scene.texcoords, "scene.texcoords");
}

}  // namespace

void check_shape(const rsh_geometry& geometry) {
    require(geometry.triangle_count < kMaxTriangles, "geometry.triangle_count",
            geometry.triangle_count, "below ", kMaxTriangles);
    require(geometry.still_triangles <= geometry.triangle_count, "geometry.still_triangles",
            geometry.still_triangles, "at most geometry.triangle_count, ",
            geometry.triangle_count);
    const cl_ulong stride = stride_of(geometry);
    require(stride >= 12 && stride % 4 == 0, "geometry.vertex_stride", stride,
            "0 or a multiple of 4, at least 12");
    require(geometry.vertices_offset % 4 == 0, "geometry.vertices_offset",
            geometry.vertices_offset, "a multiple of 4");
    require(geometry.indices_offset % 4 == 0, "geometry.indices_offset",
            geometry.indices_offset, "a multiple of 4");
    check_reserved("geometry.reserved", geometry.reserved, std::size(geometry.reserved));
    for (const cl_mem buffer : geometry.reserved_buffers)
        if (buffer)
            throw Error(RSH_INVALID_VALUE, "geometry.reserved_buffers: is set, must be NULL");
}

void check_source(const rsh_batch_source& source, const rsh_geometry& geometry) {
    if (!source.fill) throw Error(RSH_INVALID_VALUE, "batches.fill: is NULL, must not be");
    require(source.triangle_count < kMaxInBatches, "batches.triangle_count",
            source.triangle_count, "below ", kMaxInBatches);
    require((source.attributes & ~kBatchAttributes) == 0, "batches.attributes",
            source.attributes, "made of RSH_BATCH_ bits");
    require(source.batch_triangles < kMaxTriangles, "batches.batch_triangles",
            source.batch_triangles, "below ", kMaxTriangles);
    require(geometry.triangle_count == 0, "geometry.triangle_count", geometry.triangle_count,
            "0 with batches");
    require(geometry.vertex_count == 0, "geometry.vertex_count", geometry.vertex_count,
            "0 with batches");
    require(geometry.range_count == 0, "geometry.range_count", geometry.range_count,
            "0 with batches");
    refuse(geometry.vertices, "geometry.vertices", "batches");
    refuse(geometry.indices, "geometry.indices", "batches");
}

void check_buffers(Buffers& buffers, const rsh_geometry& geometry) {
    const cl_ulong vertices = geometry.vertex_count, stride = stride_of(geometry);
    buffers.in("geometry.vertices", geometry.vertices,
               vertices ? (vertices - 1) * stride + 12 : 0, geometry.vertices_offset);
    buffers.optional_in("geometry.indices", geometry.indices,
                        cl_ulong{geometry.triangle_count} * 12, geometry.indices_offset);
    buffers.in("geometry.ranges", geometry.ranges,
               cl_ulong{geometry.range_count} * sizeof(rsh_mesh_range));
}

void check_shape(const rsh_scene& scene) {
    check_shape(scene.geometry);
    require(scene.material_count >= 1, "scene.material_count", scene.material_count,
            "at least 1");
    require(scene.light_count <= RSH_MAX_LIGHTS, "scene.light_count", scene.light_count,
            "at most ", RSH_MAX_LIGHTS);
    require((scene.features & ~RSH_FEATURE_ALL) == 0, "scene.features", scene.features,
            "made of RSH_FEATURE_ bits");
    check_normals(scene);
    check_images(scene);
    check_cut(scene);
    check_vector("scene.ambient", scene.ambient);
    check_vector("scene.environment", scene.environment);
}

void check_buffers(Buffers& buffers, const rsh_scene& scene) {
    check_buffers(buffers, scene.geometry);
    const cl_ulong vertices = scene.geometry.vertex_count;
    const cl_ulong stride = scene.normal_stride ? scene.normal_stride : 12;
    buffers.optional_in("scene.normals", scene.normals,
                        vertices ? (vertices - 1) * stride + 12 : 0, scene.normals_offset);
    buffers.optional_in("scene.texcoords", scene.texcoords, vertices * 8);
    buffers.optional_in("scene.material_ids", scene.material_ids,
                        cl_ulong{scene.geometry.triangle_count} * 4);
    buffers.in("scene.materials", scene.materials,
               cl_ulong{scene.material_count} * sizeof(rsh_material));
    buffers.in("scene.lights", scene.lights, cl_ulong{scene.light_count} * sizeof(rsh_light));
    if (scene.features & RSH_FEATURE_SMOOTH_NORMAL)
        require_not_null(scene.normals, "scene.normals");
    check_image_buffers(buffers, scene);
}

void check_host_copies(const rsh_scene& scene, const rsh_material* materials,
                       const rsh_light* lights) {
    for (cl_uint i = 0; i < scene.material_count; ++i)
        check_reserved("materials[i].reserved", materials[i].reserved,
                       std::size(materials[i].reserved));
    for (cl_uint i = 0; i < scene.light_count; ++i)
        check_reserved("lights[i].reserved", lights[i].reserved, std::size(lights[i].reserved));
}

void check_shape(const rsh_bound_desc& desc) {
    check_shape(desc.geometry);
    bounds_for(desc.shape);
    require(desc.mode <= RSH_BOUND_QUALITY, "mode", desc.mode, "an RSH_BOUND_... value");
}

void check_buffers(const Context& context, const rsh_bound_desc& desc) {
    Buffers buffers(context);
    check_buffers(buffers, desc.geometry);
    buffers.out("bounds", desc.bounds, bounds_for(desc.shape).bytes(desc.geometry));
    buffers.scratch(desc.scratch,
                    bounds_for(desc.shape).scratch(context, desc.geometry, desc.mode).bytes());
}

}  // namespace rsh
