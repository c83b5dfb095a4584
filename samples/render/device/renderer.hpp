// renderer.hpp - one scene, many frames: moves the world, uploads what moved, calls rsh_frame for
// each strip of the picture, reads it and measures. Writes no file. After the first frame it
// allocates nothing.
#pragma once

#include <functional>

#include "device/device_scene.hpp"
#include "device/strips.hpp"
#include "picture/picture_writer.hpp"

namespace render {

struct RenderSettings {
    glm::uvec2 size{640, 480};
    uint32_t bounces = 4;
    float min_weight = 1e-4f;  // of 10^7 channels of the sample scenes, 155 change, by 1
    float tolerance = 0;       // see rsh_frame_desc
    uint32_t cut = RSH_CUT_BLACK;
    uint32_t engine = RSH_ENGINE_DEFAULT;
    uint32_t bound = RSH_SHAPE_DEFAULT;
    uint32_t strategy = RSH_STRATEGY_DEFAULT;
    size_t budget = 0;  // see plan_strips
    rsh_features without = 0;
    bool counts = false;  // statistics
};

// Sums over the frame's strips.
struct FrameMeasure {
    double time = 0.0;        // of the animation [s]
    double upload_ms = 0.0;   // host time: moving and uploading
    size_t upload_bytes = 0;  // of vertices, normals and lights that moved
    double total_ms =
        0.0;  // host time: from the call of rsh_frame to the end of its last command
    double read_ms = 0.0;         // host time: reading the picture
    size_t resident_bytes = 0;    // of the process, when the frame is done
    rsh_statistics statistics{};  // of rsh_frame; zero unless RenderSettings::counts
};

// What is to be done with each strip of a picture, from the top to the bottom.
using TakeStrip = std::function<void(const Strip&)>;

class Renderer {
public:
    Renderer(const rsh::Device& device, World& world, const RenderSettings& settings);

    FrameMeasure render(double time, rsh_progress progress, void* user, const TakeStrip& take);

    // Renders the last frame once more and audits so many rays of each wave of each strip. seed:
    // which ones. `first_ray` is that of the first strip with a difference.
    rsh_audit_report audit(uint32_t rays, uint32_t seed, rsh_progress progress, void* user);

    // Of the whole picture, as it was rendered last.
    rsh_frame_desc frame_desc() const;
    // Of a strip, which may be the whole picture; the last one may have less.
    uint32_t strip_rows() const { return plan_.rows; }

private:
    // Of the picture's strip from that row on.
    rsh_frame_desc strip_desc(uint32_t first_row) const;
    void make_bounds();
    void render_strip(const rsh_frame_desc& desc, FrameMeasure& measure);
    void read_strip(const rsh_frame_desc& desc, FrameMeasure& measure);

    const rsh::Device& device_;
    World& world_;
    RenderSettings settings_;
    DeviceScene scene_;
    rsh::Buffer bounds_;
    bool has_bounds_ = false;  // of an earlier frame
    StripPlan plan_;
    rsh::Buffer colour_;  // of a strip
    Strip strip_;
};

}  // namespace render
