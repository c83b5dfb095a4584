// wave_test.cpp - rsh_spawn_wave against rsh_spawn, packed on the host, and rsh_gather_wave against
// sums taken there.
#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "shade/types.h"
#include "support/compare.hpp"
#include "support/render.hpp"
#include "support/trace.hpp"

namespace {

using test::Buffer;
using test::device;
using test::DeviceScene;
using test::Scene;

struct Options {
    std::optional<uint32_t> capacity = {};  // none: enough
    std::optional<uint32_t> list_count = {};
    std::vector<uint32_t> pixels = {};
    std::vector<cl_float4> weights = {};
    float min_weight = 0;
    bool own_scratch = false;
};

struct Packed {
    std::vector<uint32_t> branches, count, skip, parents, pixels;
    std::vector<rsh_ray> rays;
    std::vector<cl_float4> weights;
    bool is_untouched;  // all that holds the next wave

    uint32_t branch(size_t ray, uint32_t kind) const { return branches[2 * ray + kind]; }
};

class Wave {
public:
    Wave(const Scene& scene, uint32_t width, uint32_t height) : scene_(scene) {
        rays = test::pinhole_rays(width, height, {0.4f, 2.2f, 5.5f}, {0, 0.8f, 0}, 3);
        test::Random random(7);
        for (size_t i = 0; i < rays.rays.size(); i += 3)
            rays.rays[i] = test::make_ray(test::Float3(1.2f, 0.9f, 1) + random.in_cube(0.4f),
                                          random.direction());
        hits = closest_hits(test::DeviceMesh(scene.mesh), rays);
    }

    test::Spawned spawn(uint32_t kind, const Options& options) const {
        test::SpawnOptions spawn;
        spawn.kind = kind;
        spawn.weights = options.weights;
        spawn.min_weight = options.min_weight;
        return test::spawn(scene_, rays.rays, hits, spawn);
    }

    Packed pack(const Options& options) const {
        const size_t n = rays.rays.size();
        const uint32_t capacity = options.capacity.value_or(uint32_t(2 * n));
        const Buffer<rsh_ray> in_rays(rays.rays), out_rays(capacity);
        const Buffer<rsh_hit> in_hits(hits);
        const Buffer<cl_float4> in_weights(options.weights), weights(capacity);
        const Buffer<uint32_t> branches(2 * n), skip(capacity), count(2), parents(capacity),
            pixels(capacity), in_pixels(options.pixels),
            list_count(std::vector<uint32_t>{options.list_count.value_or(0)});
        rsh_spawn_wave_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.scene = &scene_.desc;
        desc.width = rays.width;
        desc.height = rays.height;
        desc.rays = in_rays.get();
        desc.hits = in_hits.get();
        if (!options.weights.empty()) desc.weights = in_weights.get();
        desc.min_weight = options.min_weight;
        desc.capacity = capacity;
        desc.branches = branches.get();
        desc.spawned_rays = out_rays.get();
        desc.spawned_weights = weights.get();
        desc.spawned_skip = skip.get();
        desc.spawned_count = count.get();
        if (options.list_count) desc.list_count = list_count.get();
        desc.spawned_parents = parents.get();
        if (!options.pixels.empty()) desc.pixels = in_pixels.get();
        desc.spawned_pixels = pixels.get();
        const auto scratch = options.own_scratch ? scratch_of(desc) : nullptr;
        if (scratch) desc.scratch = scratch->get();
        RSH_CHECK(rsh_spawn_wave(device().rsh, device().queue(), &desc, 0, nullptr, nullptr));
        device().queue.finish();
        EXPECT_TRUE(out_rays.guards_intact() && weights.guards_intact() &&
                    skip.guards_intact() && parents.guards_intact() && pixels.guards_intact() &&
                    branches.guards_intact());
        if (scratch) {
            EXPECT_TRUE(scratch->guards_intact());
        }
        return {branches.read(),
                count.read(),
                skip.read(),
                parents.read(),
                pixels.read(),
                out_rays.read(),
                weights.read(),
                out_rays.untouched() && weights.untouched() && skip.untouched() &&
                    parents.untouched() && pixels.untouched()};
    }

    std::vector<cl_float4> gather(const Packed& packed, const std::vector<cl_float4>& seen,
                                  const std::vector<cl_float4>& colour) const {
        const Buffer<uint32_t> branches(packed.branches), count(packed.count);
        const Buffer<cl_float4> next(seen), sums(colour);
        rsh_gather_wave_desc desc = {};
        desc.struct_size = sizeof desc;
        desc.scene = &scene_.desc;
        desc.width = rays.width;
        desc.height = rays.height;
        desc.capacity = uint32_t(seen.size());
        desc.branches = branches.get();
        desc.spawned_count = count.get();
        desc.spawned_colour = next.get();
        desc.colour = sums.get();
        RSH_CHECK(rsh_gather_wave(device().rsh, device().queue(), &desc, 0, nullptr, nullptr));
        return sums.read();
    }

    test::Rays rays;
    std::vector<rsh_hit> hits;

private:
    static std::unique_ptr<Buffer<uint8_t>> scratch_of(const rsh_spawn_wave_desc& desc) {
        rsh_sizes sizes = {};
        sizes.struct_size = sizeof sizes;
        RSH_CHECK(rsh_spawn_wave_query(device().rsh, &desc, &sizes));
        EXPECT_EQ(sizes.output_bytes, size_t{8} * desc.width * desc.height);
        return std::make_unique<Buffer<uint8_t>>(sizes.scratch_bytes);
    }

    DeviceScene scene_;
};

// One after the other in the next wave; where there is none, rsh_spawn made none either.
void expect_branches(const Wave& wave, const Options& options, const Packed& packed) {
    const size_t rays =
        std::min<size_t>(wave.rays.rays.size(), options.list_count.value_or(0xffffffffu));
    std::vector<bool> is_met(packed.count[0]);
    size_t met = 0;
    for (uint32_t kind = 0; kind < RSH_BRANCHES; ++kind) {
        const auto spawned = wave.spawn(kind, options);
        for (size_t i = 0; i < rays; ++i) {
            const uint32_t at = packed.branch(i, kind);
            if (at == RSH_NO_RAY) {
                ASSERT_EQ(spawned.skip[i], RSH_NO_HIT) << "ray " << i << ", kind " << kind;
                continue;
            }
            ASSERT_LT(at, packed.count[0]) << "ray " << i << ", kind " << kind;
            ASSERT_FALSE(is_met[at]) << "ray " << i << ", kind " << kind;
            is_met[at] = true;
            ++met;
            ASSERT_EQ(std::memcmp(&packed.rays[at], &spawned.rays[i], sizeof(rsh_ray)), 0)
                << "ray " << i << ": " << packed.rays[at] << ", " << spawned.rays[i];
            ASSERT_EQ(std::memcmp(&packed.weights[at], &spawned.weights[i], 16), 0) << i;
            ASSERT_EQ(packed.skip[at], spawned.skip[i]) << i;
            ASSERT_EQ(packed.parents[at], i);
            ASSERT_EQ(packed.pixels[at], options.pixels.empty() ? i : options.pixels[i]);
        }
    }
    EXPECT_EQ(met, packed.count[0]) << "rays of nobody";
}

uint32_t kind_of(const Packed& packed, size_t at) {
    return packed.branch(packed.parents[at], RSH_REFLECTED) == at ? 0 : 1;
}

uint32_t side(uint32_t usual) {
    return test::small() ? usual / 4 : usual;
}

TEST(SpawnWave, PacksTheRaysOfSpawn) {
    const uint32_t shapes[][2] = {{side(150), side(130)}, {side(3000), 1}, {1, 37}};
    for (const auto& shape : shapes) {
        const Wave wave(test::gallery(), shape[0], shape[1]);
        const size_t n = wave.rays.rays.size();
        for (const bool is_weighted : {false, true}) {
            SCOPED_TRACE(std::to_string(shape[0]) + (is_weighted ? ", weighted" : ""));
            Options options;
            options.own_scratch = is_weighted;
            if (is_weighted) {
                options.min_weight = 0.3f;
                options.weights.assign(n, cl_float4{{0.5f, 0.25f, 2, 0}});
                for (size_t i = 0; i < n; ++i) options.pixels.push_back(uint32_t(7 * i + 3));
            }
            const Packed packed = wave.pack(options);
            EXPECT_EQ(packed.count[0], packed.count[1]);
            if (n > 100) {
                EXPECT_GT(packed.count[0], 0u);
            }
            expect_branches(wave, options, packed);
        }
    }
}

// Of each kind: a list in its own order, a grid by squares.
TEST(SpawnWave, PutsReflectedRaysFirstAndKeepsNeighboursTogether) {
    const uint32_t shapes[][2] = {{150, 130}, {3000, 1}};
    for (const auto& shape : shapes) {
        const Wave wave(test::gallery(), shape[0], shape[1]);
        const Packed packed = wave.pack({});
        const auto square = [&](uint32_t ray) {
            if (shape[1] == 1) return ray;
            const uint32_t columns = (shape[0] + RSH_SCREEN_SQUARE - 1) / RSH_SCREEN_SQUARE;
            return ray / shape[0] / RSH_SCREEN_SQUARE * columns +
                   ray % shape[0] / RSH_SCREEN_SQUARE;
        };
        for (size_t at = 1; at < packed.count[0]; ++at) {
            const uint32_t before = kind_of(packed, at - 1), kind = kind_of(packed, at);
            ASSERT_LE(before, kind) << at;
            if (kind == before) {
                ASSERT_LE(square(packed.parents[at - 1]), square(packed.parents[at])) << at;
            }
        }
    }
}

TEST(SpawnWave, WritesNothingWithoutRoom) {
    const Wave wave(test::gallery(), side(96), side(72));
    const uint32_t all = wave.pack({}).count[1];
    Options options;
    for (options.capacity = 0; *options.capacity < all;
         *options.capacity = 2 * *options.capacity + 1) {
        const Packed packed = wave.pack(options);
        EXPECT_EQ(packed.count[0], 0u);
        EXPECT_EQ(packed.count[1], all);
        EXPECT_TRUE(packed.is_untouched) << "capacity " << *options.capacity;
    }
    options.capacity = all - 1;
    EXPECT_TRUE(wave.pack(options).is_untouched);
    options.capacity = all;
    expect_branches(wave, options, wave.pack(options));
}

TEST(SpawnWave, TakesTheLengthOfAListFromTheDevice) {
    const uint32_t width = side(3000);
    const Wave wave(test::gallery(), width, 1);
    for (const uint32_t count : {0u, 1u, width / 2 + 5, width, width + 1}) {
        SCOPED_TRACE(count);
        Options options;
        options.list_count = count;
        const Packed packed = wave.pack(options);
        expect_branches(wave, options, packed);
        const auto untouched = Buffer<uint32_t>(2 * width).read();
        for (size_t i = 2 * size_t{count}; i < packed.branches.size(); ++i)
            ASSERT_EQ(packed.branches[i], untouched[i]) << i;
    }
}

TEST(GatherWave, AddsWhatReflectedThenRefractedRaysSee) {
    const Wave wave(test::gallery(), side(96), side(72));
    const Packed packed = wave.pack({});
    test::Random random(8);
    const auto random_colours = [&](size_t count) {
        std::vector<cl_float4> colours(count);
        for (cl_float4& colour : colours)
            for (float& c : colour.s) c = random.unit();
        return colours;
    };
    const auto seen = random_colours(packed.rays.size());
    const auto colour = random_colours(wave.rays.rays.size());
    auto expected = colour;
    for (size_t i = 0; i < expected.size(); ++i)
        for (uint32_t kind = 0; kind < RSH_BRANCHES; ++kind)
            if (packed.branch(i, kind) != RSH_NO_RAY)
                for (int c = 0; c < 3; ++c)
                    expected[i].s[c] += seen[packed.branch(i, kind)].s[c];
    EXPECT_TRUE(test::same_bits(wave.gather(packed, seen, colour), expected, "colours"));
    Options none;
    none.capacity = packed.count[1] - 1;
    EXPECT_TRUE(test::same_bits(wave.gather(wave.pack(none), seen, colour), colour, "colours"));
}

}  // namespace
