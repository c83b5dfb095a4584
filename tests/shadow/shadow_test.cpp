// shadow_test.cpp - rsh_shadow against rsh_spawn and rsh_traverse, light by light and one call after
// the other.
#include <gtest/gtest.h>

#include <memory>

#include "support/compare.hpp"
#include "support/render.hpp"
#include "support/trace.hpp"
#include "support/ways.hpp"

namespace {

using test::Buffer;
using test::device;
using test::DeviceMesh;
using test::DeviceScene;
using test::Scene;
using test::TraceOptions;

constexpr uint32_t kGarbage = 0xa5a5a5a5u;

struct Options {
    TraceOptions way;
    std::optional<uint32_t> list_count;
    cl_command_queue queue = device().queue();
};

struct Answer {
    std::vector<uint32_t> masks;
    uint32_t active;
};

// A wave of the gallery, and what one call makes of it.
class Wave {
public:
    Wave(const Scene& scene, uint32_t width, uint32_t height, rsh_features without = 0)
        : mesh_(scene.mesh), scene_(scene, without) {
        rays = test::pinhole_rays(width, height, {0.4f, 2.2f, 5.5f}, {0, 0.8f, 0}, 3);
        rays.rays[rays.rays.size() / 2] = test::inactive_ray();
        hits = closest_hits(mesh_, rays);
    }

    Answer by_the_calls(const TraceOptions& way) const {
        Answer answer = {std::vector<uint32_t>(rays.rays.size(), 0), 0};
        for (uint32_t light = 0; light < scene_.desc.light_count; ++light) {
            if (!(scene_.desc.shadow_lights >> light & 1)) continue;
            test::SpawnOptions spawn;
            spawn.kind = RSH_SPAWN_SHADOW;
            spawn.light = light;
            const auto spawned = test::spawn(scene_, rays.rays, hits, spawn);
            answer.active += spawned.active;
            answer.masks =
                occlusion(mesh_, {spawned.rays, rays.width, rays.height, spawned.skip},
                          answer.masks, light, way);
        }
        return answer;
    }

    Answer by_one_call(const Options& options) const {
        const Buffer<rsh_ray> in_rays(rays.rays);
        const Buffer<rsh_hit> in_hits(hits);
        const Buffer<uint32_t> masks(std::vector<uint32_t>(rays.rays.size(), kGarbage));
        const Buffer<uint32_t> active(std::vector<uint32_t>{1000});
        const Buffer<uint32_t> count(std::vector<uint32_t>{options.list_count.value_or(0)});
        rsh_shadow_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.scene = &scene_.desc;
        desc.width = rays.width;
        desc.height = rays.height;
        desc.rays = in_rays.get();
        desc.hits = in_hits.get();
        desc.occlusion = masks.get();
        desc.engine = options.way.engine;
        desc.shape = options.way.bound;
        desc.strategy = options.way.strategy;
        desc.active_count = active.get();
        if (options.list_count) desc.list_count = count.get();
        const auto bounds = options.way.own_bounds ? bounds_of(desc) : nullptr;
        if (bounds) desc.bounds = bounds->get();
        const auto scratch = options.way.own_scratch ? scratch_of(desc) : nullptr;
        if (scratch) desc.scratch = scratch->get();
        run(desc, options.queue);
        EXPECT_TRUE(masks.guards_intact());
        EXPECT_TRUE(active.guards_intact());
        if (scratch) {
            EXPECT_TRUE(scratch->guards_intact());
        }
        return {masks.read(), active.read()[0] - 1000};
    }

    test::Rays rays;
    std::vector<rsh_hit> hits;

private:
    static void run(const rsh_shadow_desc& desc, cl_command_queue queue) {
        cl_event raw = nullptr;
        RSH_CHECK(rsh_shadow(device().rsh, queue, &desc, 0, nullptr, &raw));
        const cl::Event done(raw);
        done.wait();
    }

    static std::unique_ptr<Buffer<uint8_t>> scratch_of(const rsh_shadow_desc& desc) {
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_shadow_query(device().rsh, &desc, &sizes));
        EXPECT_EQ(sizes.output_bytes, size_t{4} * desc.width * desc.height);
        return std::make_unique<Buffer<uint8_t>>(sizes.scratch_bytes);
    }

    static std::unique_ptr<Buffer<uint8_t>> bounds_of(const rsh_shadow_desc& shadow) {
        rsh_bound_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.geometry = shadow.scene->geometry;
        desc.shape = shadow.shape;
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_bound_query(device().rsh, &desc, &sizes));
        auto bounds = std::make_unique<Buffer<uint8_t>>(sizes.output_bytes);
        desc.bounds = bounds->get();
        RSH_CHECK(rsh_bound(device().rsh, device().queue(), &desc, 0, nullptr, nullptr));
        device().queue.finish();
        return bounds;
    }

    DeviceMesh mesh_;
    DeviceScene scene_;
};

void expect_same(const Answer& actual, const Answer& expected) {
    EXPECT_TRUE(test::same_bits(actual.masks, expected.masks, "masks"));
    EXPECT_EQ(actual.active, expected.active);
}

uint32_t side(uint32_t usual) {
    return test::small() ? usual / 4 : usual;
}

TEST(Shadow, EqualsTheCallsLightByLight) {
    const uint32_t shapes[][2] = {{side(72), side(52)}, {side(3000), 1}};
    for (const auto& shape : shapes) {
        const Wave wave(test::gallery(), shape[0], shape[1]);
        const Answer expected = wave.by_the_calls({});
        EXPECT_GT(expected.active, 0u);
        for (TraceOptions way : test::brute_force_and_all_ways())
            for (const bool is_own : {false, true}) {
                SCOPED_TRACE(name_of(way) + (is_own ? ", own memory" : ""));
                way.own_scratch = is_own;
                way.own_bounds = is_own && way.engine != RSH_ENGINE_BRUTE_FORCE;
                expect_same(wave.by_one_call({way, {}}), expected);
            }
    }
}

TEST(Shadow, TakesTheLengthOfAListFromTheDevice) {
    const uint32_t width = side(2000);
    const Wave all(test::gallery(), width, 1);
    for (const uint32_t count : {0u, 1u, width / 3, width - 1, width, width + 1, 0xffffffffu}) {
        SCOPED_TRACE(count);
        Wave first(test::gallery(), width, 1);
        first.rays.width = std::min(count, width);
        first.rays.rays.resize(first.rays.width);
        first.hits.resize(first.rays.width);
        Answer expected = first.by_the_calls({});
        expected.masks.resize(width, 0);
        for (const TraceOptions& way : test::brute_force_and_all_ways())
            expect_same(all.by_one_call({way, count}), expected);
    }
}

TEST(Shadow, LeavesNoBitWithoutTheFeature) {
    const Wave wave(test::gallery(), 20, 10, RSH_FEATURE_SHADOW);
    expect_same(wave.by_one_call({}), {std::vector<uint32_t>(200, 0), 0});
}

TEST(Shadow, KeepsItsOrderOnAnOutOfOrderQueue) {
    const Wave wave(test::gallery(), side(72), side(52));
    const cl::CommandQueue queue = device().out_of_order_queue();
    for (int repeat = 0; repeat < 5; ++repeat)
        expect_same(wave.by_one_call({{}, {}, queue()}), wave.by_the_calls({}));
}

// A mesh of nothing, and a wave of none.
TEST(Shadow, TakesNothing) {
    Scene scene = test::gallery();
    Wave wave(scene, 16, 1);
    wave.rays.width = 0;
    wave.rays.rays.clear();
    wave.hits.clear();
    EXPECT_TRUE(wave.by_one_call({}).masks.empty());
    scene.mesh = test::Mesh();
    scene.material_ids.clear();
    scene.normals.clear();
    scene.texcoords.clear();
    scene.materials[0].texture = RSH_NO_TEXTURE;
    EXPECT_EQ(Wave(scene, 16, 1).by_one_call({}).masks, std::vector<uint32_t>(16, 0));
}

// rsh_spawn's own count of a list: what it writes, and that it leaves alone what lies behind.
TEST(ListCountOfSpawn, MakesTheRaysOfAListOfThatWidth) {
    const DeviceScene scene(test::gallery());
    const uint32_t width = side(1000);
    const Wave wave(test::gallery(), width, 1);
    const Buffer<rsh_ray> rays(wave.rays.rays);
    const Buffer<rsh_hit> hits(wave.hits);
    for (const cl_uint kind : {RSH_SPAWN_REFLECTION, RSH_SPAWN_REFRACTION, RSH_SPAWN_SHADOW})
        for (const uint32_t count : {0u, width / 2 + 3, width + 7}) {
            SCOPED_TRACE(std::to_string(kind) + ", " + std::to_string(count));
            test::SpawnOptions options;
            options.kind = kind;
            auto expected = test::spawn(scene, wave.rays.rays, wave.hits, options);
            const Buffer<rsh_ray> spawned(width);
            const Buffer<cl_float4> weights(width);
            const Buffer<uint32_t> skip(width), list_count(std::vector<uint32_t>{count});
            const auto untouched = spawned.read();
            const auto keep_first = [&](auto& items, const auto& rest) {
                for (size_t i = count; i < items.size(); ++i) items[i] = rest[i];
            };
            keep_first(expected.rays, untouched);
            keep_first(expected.weights, weights.read());
            keep_first(expected.skip, skip.read());
            rsh_spawn_desc desc = {};
            desc.struct_size = sizeof desc;
            desc.scene = &scene.desc;
            desc.kind = kind;
            desc.ray_count = width;
            desc.rays = rays.get();
            desc.hits = hits.get();
            desc.spawned_rays = spawned.get();
            desc.spawned_weights = weights.get();
            desc.spawned_skip = skip.get();
            desc.list_count = list_count.get();
            RSH_CHECK(rsh_spawn(device().rsh, device().queue(), &desc, 0, nullptr, nullptr));
            EXPECT_TRUE(test::same_bits(spawned.read(), expected.rays, "rays"));
            EXPECT_TRUE(test::same_bits(skip.read(), expected.skip, "skip"));
            if (kind != RSH_SPAWN_SHADOW) {
                EXPECT_TRUE(test::same_bits(weights.read(), expected.weights, "weights"));
            }
        }
}

}  // namespace
