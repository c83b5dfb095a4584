// renderer.hpp - one scene, many frames: moves the world, uploads what moved, calls rsh_frame,
// reads the picture and measures. Writes no file. After the first frame it allocates nothing.
#pragma once

#include "device/device_scene.hpp"
#include "files/image_output.hpp"

namespace render {

struct RenderSettings {
    glm::uvec2 size{640, 480};
    uint32_t bounces = 4;
    float min_weight = 1e-4f;  // of 10^7 channels of the sample scenes, 155 change, by 1
    uint32_t cut = RSH_CUT_BLACK;
    uint32_t engine = RSH_ENGINE_DEFAULT;
    uint32_t bound = RSH_SHAPE_DEFAULT;
    uint32_t strategy = RSH_STRATEGY_DEFAULT;
    size_t budget = 0;
    rsh_features without = 0;
    bool counts = false;  // statistics
};

struct FrameMeasure {
    double time = 0.0;       // of the animation [s]
    double upload_ms = 0.0;  // host time: moving and uploading
    double total_ms =
        0.0;  // host time: from the call of rsh_frame to the end of its last command
    double read_ms = 0.0;         // host time: reading the picture
    rsh_statistics statistics{};  // of rsh_frame; zero unless RenderSettings::counts
};

class Renderer {
public:
    Renderer(const Device& device, World& world, const RenderSettings& settings);

    FrameMeasure render(double time, rsh_progress progress, void* user);
    const Frame& frame() const { return frame_; }  // of the last render

    // Renders the last frame once more and audits so many rays of each wave. seed: which ones.
    rsh_audit_report audit(uint32_t rays, uint32_t seed, rsh_progress progress, void* user);

private:
    rsh_frame_desc frame_desc() const;
    void make_bounds();

    const Device& device_;
    World& world_;
    RenderSettings settings_;
    DeviceScene scene_;
    cl::Buffer colour_, bounds_;
    bool has_bounds_ = false;  // of an earlier frame
    Frame frame_;
};

}  // namespace render
