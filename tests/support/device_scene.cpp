// device_scene.cpp - fills the buffers of an rsh_scene.
#include "support/device_scene.hpp"

namespace test {
namespace {

rsh_float4 rgb(Float3 c) {
    return {{c.x, c.y, c.z, 0}};
}

}  // namespace

template <class T>
cl_mem DeviceScene::upload(const std::vector<T>& data) {
    if (data.empty()) return nullptr;
    buffers_.push_back(std::make_unique<Bytes>(data.size() * sizeof(T), data.data()));
    return buffers_.back()->get();
}

DeviceScene::DeviceScene(const Scene& scene, rsh_features without) {
    desc.struct_size = sizeof desc;
    desc.geometry.vertices = upload(scene.mesh.vertices);
    desc.geometry.vertex_count = cl_uint(scene.mesh.vertices.size());
    desc.geometry.indices = upload(scene.mesh.indices);
    desc.geometry.triangle_count = scene.mesh.triangle_count();
    desc.normals = upload(scene.normals);
    desc.texcoords = upload(scene.texcoords);
    desc.material_ids = upload(scene.material_ids);
    desc.materials = upload(scene.materials);
    desc.material_count = cl_uint(scene.materials.size());
    desc.lights = upload(scene.lights);
    desc.light_count = cl_uint(scene.lights.size());
    desc.textures = upload(scene.textures);
    desc.texture_count = cl_uint(scene.textures.size());
    desc.texels = upload(scene.texels);
    desc.ambient = rgb(scene.ambient);
    desc.environment = rgb(scene.environment);
    desc.environment_texture = scene.environment_texture;
    desc.cut = scene.cut;
    RSH_CHECK(rsh_find_features(&desc, scene.materials.data(), scene.lights.data()));
    desc.features &= ~without;
}

}  // namespace test
