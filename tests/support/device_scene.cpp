// device_scene.cpp - fills the buffers of an rsh_scene.
#include "support/device_scene.hpp"

#include "support/placed_scene.hpp"

namespace test {

template <class T>
cl_mem DeviceScene::upload(const std::vector<T>& data) {
    if (data.empty()) return nullptr;
    buffers_.push_back(std::make_unique<Bytes>(data.size() * sizeof(T), data.data()));
    return buffers_.back()->get();
}

DeviceScene::DeviceScene(const Scene& scene, rsh_features without) {
    desc = placed(scene, [this](const auto& data) { return upload(data); });
    RSH_CHECK(rsh_find_features(&desc, scene.materials.data(), scene.lights.data()));
    desc.features &= ~without;
}

}  // namespace test
