// public_waves_test.cpp - a frame by the calls that take whole waves, on a queue that runs whatever
// it may: by events alone, and no count is read before the end. It has rsh_frame's bits.
#include <gtest/gtest.h>

#include "support/compare.hpp"
#include "support/render.hpp"

namespace {

using test::Buffer;
using test::device;

constexpr uint32_t kBounces = 3;

// The rays of a bounce, and what they see.
struct Wave {
    explicit Wave(size_t most)
        : rays(most),
          hits(most),
          weights(most),
          colour(most),
          skip(most),
          occlusion(most),
          branches(2 * most),
          count(2) {}

    Buffer<rsh_ray> rays;
    Buffer<rsh_hit> hits;
    Buffer<cl_float4> weights, colour;
    Buffer<uint32_t> skip, occlusion, branches, count;
};

template <class Desc>
Desc made(const rsh_scene& scene) {
    Desc desc = {};
    desc.struct_size = sizeof desc;
    desc.scene = &scene;
    return desc;
}

class Loop {
public:
    Loop(const test::DeviceScene& scene, const test::FrameOptions& options)
        : scene_(scene.desc), options_(options) {
        for (uint32_t bounce = 0; bounce <= kBounces; ++bounce)
            waves_.push_back(std::make_unique<Wave>(2 * size_t{width()} * height()));
    }

    std::vector<cl_float4> render() {
        rasterize();
        for (uint32_t bounce = 0; bounce <= kBounces; ++bounce) {
            if (bounce > 0) trace(bounce);
            shade(bounce);
            if (bounce < kBounces) spawn(bounce);
        }
        for (uint32_t bounce = kBounces; bounce-- > 0;) gather(bounce);
        last_.wait();
        std::vector<cl_float4> colour = waves_[0]->colour.read();
        const auto hits = waves_[0]->hits.read();
        colour.resize(size_t{width()} * height());
        for (size_t i = 0; i < colour.size(); ++i)
            colour[i].s[3] = hits[i].primitive == RSH_NO_HIT ? 0.0f : 1.0f;
        return colour;
    }

private:
    uint32_t width() const { return options_.width; }
    uint32_t height() const { return options_.height; }
    // Of the first wave a screen, of the others a list that the device knows the length of.
    uint32_t columns(uint32_t bounce) const {
        return bounce ? 2 * width() * height() : width();
    }
    uint32_t rows(uint32_t bounce) const { return bounce ? 1 : height(); }
    cl_mem count(uint32_t bounce) const {
        return bounce ? waves_[bounce]->count.get() : nullptr;
    }

    // After all before it.
    template <class Function, class Desc>
    void call(Function function, const Desc& desc) {
        const bool is_first = last_() == nullptr;
        cl_event done = nullptr;
        RSH_CHECK(function(device().rsh, queue_(), &desc, is_first ? 0u : 1u,
                           is_first ? nullptr : &last_(), &done));
        last_ = cl::Event(done);
    }

    void rasterize() {
        rsh_rasterize_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.geometry = scene_.geometry;
        desc.camera = test::gallery_camera(width(), height());
        desc.width = width();
        desc.height = height();
        desc.rays = waves_[0]->rays.get();
        desc.hits = waves_[0]->hits.get();
        call(rsh_rasterize, desc);
    }

    void trace(uint32_t bounce) {
        rsh_build_desc build = {};
        build.struct_size = sizeof build;
        build.rays = waves_[bounce]->rays.get();
        build.width = columns(bounce);
        build.height = rows(bounce);
        build.list_count = count(bounce);
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_build_query(device().rsh, &build, &sizes));
        if (!nodes_) nodes_ = std::make_unique<Buffer<uint8_t>>(sizes.output_bytes);
        build.nodes = nodes_->get();
        call(rsh_build, build);
        rsh_traverse_desc traverse = {};
        traverse.struct_size = sizeof traverse;
        traverse.geometry = scene_.geometry;
        traverse.rays = build.rays;
        traverse.nodes = build.nodes;
        traverse.width = build.width;
        traverse.height = build.height;
        traverse.hits = waves_[bounce]->hits.get();
        traverse.skip = waves_[bounce]->skip.get();
        traverse.list_count = build.list_count;
        call(rsh_traverse, traverse);
    }

    void shade(uint32_t bounce) {
        const Wave& wave = *waves_[bounce];
        auto shadow = made<rsh_shadow_desc>(scene_);
        shadow.width = columns(bounce);
        shadow.height = rows(bounce);
        shadow.rays = wave.rays.get();
        shadow.hits = wave.hits.get();
        shadow.occlusion = wave.occlusion.get();
        shadow.list_count = count(bounce);
        call(rsh_shadow, shadow);
        wave.colour.write(std::vector<cl_float4>(wave.colour.count(), cl_float4{{0, 0, 0, 0}}));
        auto desc = made<rsh_shade_desc>(scene_);
        desc.ray_count = columns(bounce) * rows(bounce);
        desc.rays = wave.rays.get();
        desc.hits = wave.hits.get();
        if (bounce) desc.weights = wave.weights.get();
        desc.occlusion = wave.occlusion.get();
        desc.colour = wave.colour.get();
        desc.list_count = count(bounce);
        call(rsh_shade, desc);
    }

    void spawn(uint32_t bounce) {
        const Wave &wave = *waves_[bounce], &next = *waves_[bounce + 1];
        auto desc = made<rsh_spawn_wave_desc>(scene_);
        desc.width = columns(bounce);
        desc.height = rows(bounce);
        desc.rays = wave.rays.get();
        desc.hits = wave.hits.get();
        if (bounce) desc.weights = wave.weights.get();
        desc.min_weight = options_.min_weight;
        desc.capacity = columns(bounce + 1);
        desc.branches = wave.branches.get();
        desc.spawned_rays = next.rays.get();
        desc.spawned_weights = next.weights.get();
        desc.spawned_skip = next.skip.get();
        desc.spawned_count = next.count.get();
        desc.list_count = count(bounce);
        call(rsh_spawn_wave, desc);
    }

    void gather(uint32_t bounce) {
        auto desc = made<rsh_gather_wave_desc>(scene_);
        desc.width = columns(bounce);
        desc.height = rows(bounce);
        desc.capacity = columns(bounce + 1);
        desc.branches = waves_[bounce]->branches.get();
        desc.spawned_count = waves_[bounce + 1]->count.get();
        desc.spawned_colour = waves_[bounce + 1]->colour.get();
        desc.colour = waves_[bounce]->colour.get();
        desc.list_count = count(bounce);
        call(rsh_gather_wave, desc);
    }

    const rsh_scene& scene_;
    const test::FrameOptions options_;
    const cl::CommandQueue queue_ = device().out_of_order_queue();
    std::vector<std::unique_ptr<Wave>> waves_;
    std::unique_ptr<Buffer<uint8_t>> nodes_;
    cl::Event last_;
};

TEST(Frame, EqualsTheLoopOfTheCallsThatTakeWaves) {
    test::FrameOptions options;
    options.width = test::small() ? 16 : 80;
    options.height = test::small() ? 12 : 60;
    options.bounces = kBounces;
    options.min_weight = 0.01f;
    const test::DeviceScene scene(test::gallery());
    const auto image = test::frame(scene, options);
    EXPECT_TRUE(test::same_bits(Loop(scene, options).render(), image, "pixels"));
}

}  // namespace
