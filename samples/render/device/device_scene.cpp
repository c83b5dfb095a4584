// device_scene.cpp - fills the buffers of an rsh_scene.
#include "device/device_scene.hpp"

#include <cstring>

#include "scene/device_structs.hpp"

namespace render {

DeviceScene::DeviceScene(const rsh::Device& device, const World& world, rsh_features without,
                         uint32_t cut)
    : device_(device) {
    scene_.struct_size = sizeof scene_;
    fill_geometry(world);
    fill_shading(world);
    find_features(world, without);
    scene_.cut = cut;
}

void DeviceScene::fill_geometry(const World& world) {
    const Mesh& mesh = world.mesh();
    positions_ = device_.upload(mesh.positions);
    indices_ = device_.upload(mesh.triangles);
    normals_ = device_.upload(mesh.normals);
    texcoords_ = device_.upload(mesh.texcoords);
    material_ids_ = device_.upload(mesh.material_ids);
    scene_.geometry.vertices = positions_.get();
    scene_.geometry.vertex_count = static_cast<cl_uint>(mesh.positions.size());
    scene_.geometry.indices = indices_.get();
    scene_.geometry.triangle_count = static_cast<cl_uint>(mesh.triangles.size());
    scene_.geometry.still_triangles = static_cast<cl_uint>(world.still_triangles());
    scene_.normals = normals_.get();
    scene_.texcoords = texcoords_.get();
    scene_.material_ids = material_ids_.get();
}

void DeviceScene::fill_shading(const World& world) {
    for (const Light& light : world.lights()) host_lights_.push_back(device_light(light));
    materials_ = device_.upload(world.materials());
    lights_ = device_.upload(host_lights_);
    textures_ = device_.upload(world.textures().textures());
    texels_ = device_.upload(world.textures().texels());
    scene_.materials = materials_.get();
    scene_.material_count = static_cast<cl_uint>(world.materials().size());
    scene_.lights = lights_.get();
    scene_.light_count = static_cast<cl_uint>(host_lights_.size());
    scene_.textures = textures_.get();
    scene_.texture_count = static_cast<cl_uint>(world.textures().textures().size());
    scene_.texels = texels_.get();
    scene_.ambient = device_vector(world.ambient());
    scene_.environment = device_vector(world.environment());
    scene_.environment_texture = world.environment_texture();
}

void DeviceScene::find_features(const World& world, rsh_features without) {
    rsh::check(rsh_find_features(&scene_, world.materials().data(), host_lights_.data()),
               "rsh_find_features");
    scene_.features &= ~without;
    if (without & RSH_FEATURE_SHADOW) scene_.shadow_lights = 0;
}

template <typename T>
size_t DeviceScene::update(const rsh::Buffer& buffer, const T* values, size_t first,
                           size_t count) const {
    rsh::check_opencl(
        clEnqueueWriteBuffer(device_.queue(), buffer.get(), CL_FALSE, first * sizeof(T),
                             count * sizeof(T), values + first, 0, nullptr, nullptr),
        "clEnqueueWriteBuffer");
    return count * sizeof(T);
}

size_t DeviceScene::update(const World& world) {
    const Mesh& mesh = world.mesh();
    size_t bytes = 0;
    for (const VertexRange& range : world.moved())
        bytes += update(positions_, mesh.positions.data(), range.first, range.count);
    for (const VertexRange& range : world.moved_normals())
        bytes += update(normals_, mesh.normals.data(), range.first, range.count);
    if (world.has_turned_triangles())
        bytes += update(indices_, mesh.triangles.data(), world.still_triangles(),
                        mesh.triangles.size() - world.still_triangles());
    return bytes + update_lights(world.lights());
}

size_t DeviceScene::update_lights(const std::vector<Light>& lights) {
    bool has_changed = false;
    for (size_t i = 0; i < host_lights_.size(); ++i) {
        const rsh_light now = device_light(lights.at(i));
        has_changed |= std::memcmp(&now, &host_lights_[i], sizeof now) != 0;
        host_lights_[i] = now;
    }
    return has_changed ? update(lights_, host_lights_.data(), 0, host_lights_.size()) : 0;
}

}  // namespace render
