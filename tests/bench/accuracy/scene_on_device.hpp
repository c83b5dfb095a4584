// scene_on_device.hpp - a scene in buffers, and frames of it.
#pragma once

#include "accuracy/axes.hpp"
#include "accuracy/image.hpp"
#include "accuracy/scenes.hpp"
#include "device.hpp"
#include "stability/family.hpp"

namespace bench::accuracy {

Image image_of(const std::vector<cl_float4>& pixels, uint32_t width, uint32_t height);

class SceneOnDevice {
public:
    SceneOnDevice(const Device& device, const Staged& staged);

    const Device& device() const { return device_; }
    const rsh_camera& camera() const { return camera_; }
    rsh_features features() const { return scene_.features; }
    rsh_scene without(rsh_features features) const;

    // The camera's rays of a picture, and what rsh_rasterize finds along them.
    std::vector<rsh_ray> first_rays(cl_uint width, cl_uint height,
                                    std::vector<rsh_hit>* hits) const;

private:
    const Device& device_;
    rsh_camera camera_;
    std::vector<cl::Buffer> buffers_;  // of the scene
    rsh_scene scene_{};
};

// Frames of one setting, with buffers of its own that are made once. The scene's bounds are made anew in
// every frame.
class FrameOnDevice {
public:
    FrameOnDevice(const SceneOnDevice& scene, cl_uint width, cl_uint height,
                  const Setting& setting);
    FrameOnDevice(const FrameOnDevice&) = delete;
    FrameOnDevice& operator=(const FrameOnDevice&) = delete;

    double render();                        // milliseconds; BLOCKS
    std::vector<cl_float4> pixels() const;  // of the last frame

private:
    const Device& device_;
    rsh_scene scene_;
    rsh_frame_desc desc_{};
    cl::Buffer colour_, scratch_;
};

}  // namespace bench::accuracy
