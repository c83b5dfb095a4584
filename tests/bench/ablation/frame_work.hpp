// frame_work.hpp - a frame of a scene, with the features that it is told.
#pragma once

#include "ablation/work.hpp"
#include "support/scene.hpp"

namespace bench::ablation {

struct FrameSetup {
    test::Scene scene;
    rsh_features also = 0;  // features beyond those that rsh_find_features finds
    cl_uint bounces = 0;
    cl_uint audit_rays = 0;
    float min_weight = 0;
    bool is_profiled = false;  // the queue keeps the times of commands
};

class FrameWork final : public Work {
public:
    FrameWork(const Device& device, const FrameSetup& setup, cl_uint width, cl_uint height);

    void run(rsh_context context) override;
    void prepare(rsh_context context) const override;
    std::vector<uint8_t> answer() const override;
    bool is_right(rsh_context context) const override;
    std::string programs() const override;

private:
    void place(const test::Scene& scene, rsh_features also);

    std::vector<cl::Buffer> buffers_;  // of the scene
    cl::Buffer colour_, scratch_, audit_;
    rsh_scene scene_{};
    rsh_frame_desc desc_{};
};

}  // namespace bench::ablation
