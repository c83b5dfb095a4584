// scene_on_device.cpp - fills the buffers of an rsh_scene without textures.
#include "frame/scene_on_device.hpp"

#include "scene/device_structs.hpp"

namespace bench {

template <typename T>
cl::Buffer SceneOnDevice::upload(const std::vector<T>& items) const {
    if (items.empty()) return cl::Buffer();
    const size_t bytes = items.size() * sizeof(T);
    cl::Buffer buffer(device_.context(), CL_MEM_READ_WRITE, bytes);
    device_.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, items.data());
    return buffer;
}

SceneOnDevice::SceneOnDevice(const Device& device, const FrameScene& scene)
    : device_(device), frame_(scene), positions_(scene.mesh().positions) {
    const render::Mesh& mesh = scene.mesh();
    std::vector<rsh_light> lights;
    for (const render::Light& light : scene.lights()) lights.push_back(device_light(light));
    vertices_ = upload(mesh.positions);
    indices_ = upload(mesh.triangles);
    normals_ = upload(mesh.normals);
    material_ids_ = upload(mesh.material_ids);
    materials_ = upload(scene.materials());
    lights_ = upload(lights);
    positions_.emplace_back(0.0f);

    scene_.struct_size = sizeof scene_;
    scene_.geometry.vertices = vertices_();
    scene_.geometry.vertex_count = static_cast<cl_uint>(mesh.positions.size());
    scene_.geometry.indices = indices_();
    scene_.geometry.triangle_count = static_cast<cl_uint>(mesh.triangles.size());
    scene_.normals = normals_();
    scene_.material_ids = material_ids_();
    scene_.materials = materials_();
    scene_.material_count = static_cast<cl_uint>(scene.materials().size());
    scene_.lights = lights_();
    scene_.light_count = static_cast<cl_uint>(lights.size());
    rsh::check(rsh_find_features(&scene_, scene.materials().data(), lights.data()),
               "rsh_find_features");
}

void SceneOnDevice::move(double time) {
    frame_.move(time, positions_);
    device_.queue().enqueueWriteBuffer(vertices_, CL_TRUE, 0,
                                       scene_.geometry.vertex_count * sizeof(glm::vec3),
                                       positions_.data());
}

}  // namespace bench
