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
    DeviceScene(const rsh::Device& device, const World& world, rsh_features without,
                uint32_t cut);

    // Uploads the vertices and normals of World::moved(), lights if one has changed, and the
    // triangles that move if some of them turned round. Allocates nothing. Returns the bytes.
    size_t update(const World& world);

    const rsh_scene& scene() const { return scene_; }

private:
    // Uploads values[first], ..., and returns their bytes; does not wait, so they must stay.
    template <typename T>
    size_t update(const rsh::Buffer& buffer, const T* values, size_t first, size_t count) const;
    size_t update_lights(const std::vector<Light>& lights);
    void fill_geometry(const World& world);
    void fill_shading(const World& world);
    void find_features(const World& world, rsh_features without);

    const rsh::Device& device_;
    rsh::Buffer positions_, indices_, normals_, texcoords_, material_ids_;
    rsh::Buffer materials_, lights_, textures_, texels_;
    std::vector<rsh_light> host_lights_;
    rsh_scene scene_{};
};

}  // namespace render
