// moving_frames_test.cpp - frames of 80,000 triangles that move, one reflection, one light with shadow:
// after the first one nothing is allocated and nothing compiled, and memory stays as it is.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <memory>

#include "support/buffer.hpp"
#include "support/layers/counted.hpp"
#include "support/render.hpp"

namespace {

using test::device;
using test::Float3;

test::Scene mirror_torus() {
    test::Scene scene = test::plain();
    scene.materials[0].reflection = {{0.5f, 0.5f, 0.5f, 0}};
    scene.lights[0].casts_shadow = 1;
    scene.mesh = test::torus(200, 200);
    scene.material_ids.assign(scene.mesh.triangle_count(), 0);
    return scene;
}

// Bounds are made with the first frame and refitted with the others.
class MovingFrames {
public:
    explicit MovingFrames(cl_uint side) : colour_(size_t{side} * side) {
        scene_.desc.geometry.vertices = vertices_.get();
        desc_.struct_size = sizeof desc_;
        desc_.scene = &scene_.desc;
        desc_.camera = test::look_at({0.5f, 2, 2.5f}, {0, 0, 0}, side, side);
        desc_.width = desc_.height = side;
        desc_.bounces = 1;
        desc_.colour = colour_.get();
        rsh_bound_desc bound = {};
        bound.struct_size = sizeof bound;
        bound.geometry = scene_.desc.geometry;
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_bound_query(context_.get(), &bound, &sizes));
        bounds_ = std::make_unique<test::Buffer<uint8_t>>(sizes.output_bytes);
        desc_.bounds = bounds_->get();
        desc_.mode = RSH_BOUND_QUALITY;
    }

    rsh_counts render(float time) {
        std::vector<Float3> moved = host_.mesh.vertices;
        for (Float3& p : moved) p = p + Float3{0, 0.1f * std::sin(3 * p.x + time), 0};
        vertices_.write(moved);
        const test::Since begin;
        RSH_CHECK(rsh_frame(context_.get(), device().queue(), &desc_, 0, nullptr, nullptr));
        const rsh_counts counts = begin.now();
        device().queue.finish();
        desc_.mode = RSH_BOUND_REFIT;
        return counts;
    }

    size_t active_pixels() const {
        size_t count = 0;
        for (const cl_float4& pixel : colour_.read()) count += pixel.s[1] != 0;
        return count;
    }

private:
    const test::Scene host_ = mirror_torus();
    test::DeviceScene scene_{host_};
    const test::Buffer<Float3> vertices_{host_.mesh.vertices};
    const test::Buffer<cl_float4> colour_;
    const test::OwnContext context_;
    std::unique_ptr<test::Buffer<uint8_t>> bounds_;
    rsh_frame_desc desc_ = {};
};

TEST(MovingFrames, MakeNothingAfterTheFirst) {
    MovingFrames frames(512);
    EXPECT_GT(frames.render(0).buffers, 0u);
    for (int frame = 1; frame < 4; ++frame) {
        SCOPED_TRACE("frame " + std::to_string(frame));
        const rsh_counts counts = frames.render(0.1f * float(frame));
        test::expect_nothing_made(counts);
        EXPECT_EQ(counts.bytes_alive, 0u);
    }
    EXPECT_GT(frames.active_pixels(), 512u * 512u / 4);
}

size_t resident_bytes() {
    size_t pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return resident * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

TEST(MovingFrames, LeaveTheMemoryOfTheProcessAsItIs) {
    constexpr size_t kMostGrowth = 10u << 20;
    MovingFrames frames(64);
    for (int frame = 0; frame < 30; ++frame) frames.render(0.1f * float(frame));
    const size_t before = resident_bytes();
    ASSERT_GT(before, 0u);
    for (int frame = 30; frame < 330; ++frame) frames.render(0.1f * float(frame));
    EXPECT_LE(resident_bytes(), before + kMostGrowth);
}

}  // namespace
