// frame.hpp - frames by rsh_frame of a scene that may be another one each time, with buffers that are made
// once. The scene's bounds are made anew in every frame, as in the paper.
#pragma once

#include <array>

#include "device.hpp"
#include "frame/ray_maker.hpp"

namespace bench::paper {

struct FrameSettings {
    Size size;
    cl_uint bounces = 1;
    cl_uint engine = RSH_ENGINE_DEFAULT;
    cl_uint strategy = RSH_STRATEGY_DEFAULT;  // of the engine paper_faithful
    size_t budget = 0;
};

struct FrameWork {
    double frame_ms = 0;  // by the host's clock, of the frame that was counted
    std::array<double, RSH_STAGE_COUNT> stage_ms{};  // of the device, by events
    rsh_statistics statistics{};

    double ms() const;       // bound, build, traverse of all waves
    double batches() const;  // of triangles, per traversal
};

class Frame {
public:
    Frame(const Device& device, const FrameSettings& settings);
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

    // Buffers of `scene` must live until the next one. As many triangles as that of allocate().
    void place(const rsh_scene& scene, const rsh_camera& camera);
    // After place(): the triangles come from there instead. The source must live as long.
    void take_batches(const rsh_batch_source& source);
    std::vector<NamedBytes> needs();  // after place()
    void allocate();

    double render();                        // milliseconds by the host's clock; BLOCKS
    FrameWork count();                      // one more, with statistics; BLOCKS
    std::vector<cl_float4> pixels() const;  // of the last one
    // One more, of which a sample of rays of each wave is traced by brute force; BLOCKS.
    rsh_audit_report audit(double tests_per_wave);
    size_t scratch_bytes() const { return scratch_bytes_; }

private:
    const Device& device_;
    rsh_scene scene_{};
    rsh_frame_desc desc_{};
    cl::Buffer colour_, scratch_;
    size_t scratch_bytes_ = 0;
};

}  // namespace bench::paper
