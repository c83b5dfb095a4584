// kept_frames.hpp - frames as a renderer makes them: bounds of the first are made to be kept, and
// refitted for all that follow.
#pragma once

#include "support/render.hpp"

namespace test {

class KeptFrames {
public:
    // The scene may change from frame to frame, but to no more triangles than here.
    KeptFrames(cl_uint engine, const rsh_geometry& largest)
        : engine_(engine), bounds_(bounds_bytes(engine, largest)) {}

    // Engine, bounds and mode of the options do not count.
    std::vector<cl_float4> render(const DeviceScene& scene, FrameOptions options) {
        options.engine = engine_;
        options.bounds = bounds_.get();
        options.update = mode_;
        mode_ = RSH_BOUND_REFIT;
        const auto pixels = frame(scene, options);
        EXPECT_TRUE(bounds_.guards_intact());
        return pixels;
    }

private:
    static size_t bounds_bytes(cl_uint engine, const rsh_geometry& geometry) {
        rsh_bound_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.geometry = geometry;
        desc.shape = rsh_engine_shape(engine);
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_bound_query(device().rsh, &desc, &sizes));
        return sizes.output_bytes;
    }

    cl_uint engine_;
    cl_uint mode_ = RSH_BOUND_QUALITY;
    Buffer<uint8_t> bounds_;
};

}  // namespace test
