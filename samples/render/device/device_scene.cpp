// device_scene.cpp - fills the buffers of an rsh_scene.
#include "device/device_scene.hpp"

#include "scene/device_structs.hpp"

namespace render {

template <typename T>
cl::Buffer DeviceScene::upload(const std::vector<T>& items) const {
    if (items.empty()) return cl::Buffer();  // NULL: the scene has none
    const size_t bytes = items.size() * sizeof(T);
    cl::Buffer buffer = device_.buffer(bytes);
    device_.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, items.data());
    return buffer;
}

DeviceScene::DeviceScene(const Device& device, const World& world, rsh_features without,
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
    positions_ = upload(mesh.positions);
    indices_ = upload(mesh.triangles);
    normals_ = upload(mesh.normals);
    texcoords_ = upload(mesh.texcoords);
    material_ids_ = upload(mesh.material_ids);
    scene_.geometry.vertices = positions_();
    scene_.geometry.vertex_count = static_cast<cl_uint>(mesh.positions.size());
    scene_.geometry.indices = indices_();
    scene_.geometry.triangle_count = static_cast<cl_uint>(mesh.triangles.size());
    scene_.normals = normals_();
    scene_.texcoords = texcoords_();
    scene_.material_ids = material_ids_();
}

void DeviceScene::fill_shading(const World& world) {
    for (const Light& light : world.lights()) host_lights_.push_back(device_light(light));
    materials_ = upload(world.materials());
    lights_ = upload(host_lights_);
    textures_ = upload(world.textures().textures());
    texels_ = upload(world.textures().texels());
    scene_.materials = materials_();
    scene_.material_count = static_cast<cl_uint>(world.materials().size());
    scene_.lights = lights_();
    scene_.light_count = static_cast<cl_uint>(host_lights_.size());
    scene_.textures = textures_();
    scene_.texture_count = static_cast<cl_uint>(world.textures().textures().size());
    scene_.texels = texels_();
    scene_.ambient = device_vector(world.ambient());
    scene_.environment = device_vector(world.environment());
    scene_.environment_texture = world.environment_texture();
}

void DeviceScene::find_features(const World& world, rsh_features without) {
    require(rsh_find_features(&scene_, world.materials().data(), host_lights_.data()),
            "rsh_find_features");
    scene_.features &= ~without;
    if (without & RSH_FEATURE_SHADOW) scene_.shadow_lights = 0;
}

void DeviceScene::update(const World& world) {
    const Mesh& mesh = world.mesh();
    const cl::CommandQueue& queue = device_.queue();
    for (const VertexRange& range : world.moved()) {
        const size_t offset = range.first * sizeof(glm::vec3);
        const size_t bytes = range.count * sizeof(glm::vec3);
        queue.enqueueWriteBuffer(positions_, CL_FALSE, offset, bytes,
                                 &mesh.positions[range.first]);
        if (!mesh.normals.empty())
            queue.enqueueWriteBuffer(normals_, CL_FALSE, offset, bytes,
                                     &mesh.normals[range.first]);
    }
    if (world.has_turned_triangles())
        queue.enqueueWriteBuffer(indices_, CL_FALSE, 0,
                                 mesh.triangles.size() * sizeof(glm::uvec3),
                                 mesh.triangles.data());
    if (world.moved().empty() || host_lights_.empty()) return;
    for (size_t i = 0; i < host_lights_.size(); ++i)
        host_lights_[i] = device_light(world.lights().at(i));
    queue.enqueueWriteBuffer(lights_, CL_FALSE, 0, host_lights_.size() * sizeof(rsh_light),
                             host_lights_.data());
}

}  // namespace render
