// device_scene.hpp - a World in device buffers: uploaded once, and per frame only what moved.
// Does not render.
#pragma once

#include "device/device.hpp"
#include "scene/world.hpp"

namespace render {

class DeviceScene {
public:
    // `without` are features to leave out although the scene has them.
    // `cut`: RSH_CUT_...
    DeviceScene(const Device& device, const World& world, rsh_features without, uint32_t cut);

    // Uploads the vertices, normals and lights of World::moved(), and triangles that turned round.
    // Allocates nothing.
    void update(const World& world);

    const rsh_scene& scene() const { return scene_; }

private:
    template <typename T>
    cl::Buffer upload(const std::vector<T>& items) const;
    void fill_geometry(const World& world);
    void fill_shading(const World& world);
    void find_features(const World& world, rsh_features without);

    const Device& device_;
    cl::Buffer positions_, indices_, normals_, texcoords_, material_ids_;
    cl::Buffer materials_, lights_, textures_, texels_;
    std::vector<rsh_light> host_lights_;
    rsh_scene scene_{};
};

}  // namespace render
