// list_count_test.cpp - rsh_spawn and rsh_shade of a list whose length is on the device: what they
// make of the rays that there are is that of a call for so many, and nothing else is touched.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "support/buffer.hpp"
#include "support/mesh.hpp"
#include "support/rays.hpp"
#include "support/render.hpp"
#include "support/scene.hpp"
#include "support/trace.hpp"

namespace {

// Some of the rays of a picture that hit, and some that do not.
class Wave {
public:
    Wave() : scene_(test::gallery()), device_(scene_) {
        const uint32_t width = test::small() ? 12 : 67, height = test::small() ? 5 : 31;
        const test::Rays rays =
            test::pinhole_rays(width, height, {0.4f, 2.2f, 5.5f}, {0, 0.8f, 0}, 3);
        rays_ = std::make_unique<test::Buffer<rsh_ray>>(rays.rays);
        hits_ = std::make_unique<test::Buffer<rsh_hit>>(
            closest_hits(test::DeviceMesh(scene_.mesh), rays));
    }

    cl_uint count() const { return cl_uint(rays_->count()); }

    // The bytes of all outputs, which begin as canaries. list_count NULL: of `rays` rays.
    std::vector<uint8_t> spawn(cl_uint kind, cl_uint rays, cl_mem list_count) const {
        const test::Buffer<rsh_ray> spawned(count());
        const test::Buffer<cl_float4> weights(count());
        const test::Buffer<uint32_t> skip(count());
        rsh_spawn_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.scene = &device_.desc;
        desc.kind = kind;
        desc.ray_count = rays;
        desc.rays = rays_->get();
        desc.hits = hits_->get();
        desc.spawned_rays = spawned.get();
        desc.spawned_weights = weights.get();
        desc.spawned_skip = skip.get();
        desc.list_count = list_count;
        RSH_CHECK(
            rsh_spawn(test::device().rsh, test::device().queue(), &desc, 0, nullptr, nullptr));
        std::vector<uint8_t> bytes;
        append(bytes, spawned.read());
        append(bytes, weights.read());
        append(bytes, skip.read());
        return bytes;
    }

    std::vector<uint8_t> shade(cl_uint rays, cl_mem list_count) const {
        const test::Buffer<cl_float4> colour(
            std::vector<cl_float4>(count(), cl_float4{{0.5f, 0.25f, 0, 1}}));
        rsh_shade_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.scene = &device_.desc;
        desc.ray_count = rays;
        desc.rays = rays_->get();
        desc.hits = hits_->get();
        desc.colour = colour.get();
        desc.list_count = list_count;
        RSH_CHECK(
            rsh_shade(test::device().rsh, test::device().queue(), &desc, 0, nullptr, nullptr));
        std::vector<uint8_t> bytes;
        append(bytes, colour.read());
        return bytes;
    }

private:
    template <class T>
    static void append(std::vector<uint8_t>& bytes, const std::vector<T>& data) {
        const size_t before = bytes.size();
        bytes.resize(before + data.size() * sizeof(T));
        std::memcpy(bytes.data() + before, data.data(), data.size() * sizeof(T));
    }

    const test::Scene scene_;
    const test::DeviceScene device_;
    std::unique_ptr<test::Buffer<rsh_ray>> rays_;
    std::unique_ptr<test::Buffer<rsh_hit>> hits_;
};

std::vector<cl_uint> counts_of(cl_uint all) {
    test::Random random(41);
    std::vector<cl_uint> counts = {0, 1, 15, 16, 17, all - 1, all, all + 1, ~0u};
    for (int i = 0; i < 4; ++i) counts.push_back(random.below(all));
    return counts;
}

TEST(ShadeListCount, OfSpawnIsThatOfAShorterCall) {
    const Wave wave;
    for (const cl_uint count : counts_of(wave.count()))
        for (const cl_uint kind :
             {RSH_SPAWN_REFLECTION, RSH_SPAWN_REFRACTION, RSH_SPAWN_SHADOW}) {
            const test::Buffer<cl_uint> on_device(std::vector<cl_uint>{count});
            EXPECT_EQ(wave.spawn(kind, wave.count(), on_device.get()),
                      wave.spawn(kind, std::min(count, wave.count()), nullptr))
                << "kind " << kind << ", " << count << " of " << wave.count() << " rays";
        }
}

TEST(ShadeListCount, OfShadeIsThatOfAShorterCall) {
    const Wave wave;
    for (const cl_uint count : counts_of(wave.count())) {
        const test::Buffer<cl_uint> on_device(std::vector<cl_uint>{count});
        EXPECT_EQ(wave.shade(wave.count(), on_device.get()),
                  wave.shade(std::min(count, wave.count()), nullptr))
            << count << " of " << wave.count() << " rays";
    }
}

}  // namespace
