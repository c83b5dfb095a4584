// scene_on_device.hpp - a FrameScene in device buffers and in host memory that peers share.
// Moving it writes both; nobody's timing contains that.
#pragma once

#include "device.hpp"
#include "frame/frame_scene.hpp"

namespace bench {

class SceneOnDevice {
public:
    SceneOnDevice(const Device& device, const FrameScene& scene);

    // BLOCKS until the vertices are written.
    void move(double time);

    const FrameScene& frame_scene() const { return frame_; }
    const rsh_scene& scene() const { return scene_; }
    const rsh_geometry& geometry() const { return scene_.geometry; }
    // At the last moment; one vertex more than the mesh has, which Embree may read.
    const std::vector<glm::vec3>& positions() const { return positions_; }

private:
    template <typename T>
    cl::Buffer upload(const std::vector<T>& items) const;

    const Device& device_;
    const FrameScene& frame_;
    std::vector<glm::vec3> positions_;
    cl::Buffer vertices_, indices_, normals_, material_ids_, materials_, lights_;
    rsh_scene scene_{};
};

}  // namespace bench
