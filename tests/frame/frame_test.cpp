// frame_test.cpp - rsh_frame is the loop of the public calls, gives the same bytes every time
// and under every budget, and a feature that is left out is a feature that the scene does not
// have.
#include <gtest/gtest.h>

#include "support/compare.hpp"
#include "support/kept_frames.hpp"
#include "support/render.hpp"
#include "support/strategies.hpp"
#include "support/ways.hpp"

namespace {

using test::FrameOptions;
using test::Scene;

FrameOptions sized(uint32_t width, uint32_t height, uint32_t bounces) {
    FrameOptions options;
    options.width = test::small() ? std::min(width, 16u) : width;
    options.height = test::small() ? std::min(height, 12u) : height;
    options.bounces = bounces;
    return options;
}

void expect_finite(const std::vector<cl_float4>& image) {
    for (size_t i = 0; i < image.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            ASSERT_TRUE(std::isfinite(image[i].s[c])) << "pixel " << i << " " << image[i];
            ASSERT_GE(image[i].s[c], 0) << "pixel " << i << " " << image[i];
        }
        ASSERT_TRUE(image[i].s[3] == 0 || image[i].s[3] == 1) << "alpha of pixel " << i;
    }
}

// A screen of rays for each branch of the ray tree, which rsh_frame packs; a pixel's sum is taken as
// rsh.h says: what a ray sees itself, then what its reflection sees, then its refraction.
class HandRolled {
public:
    HandRolled(const Scene& scene, const FrameOptions& options)
        : mesh_(scene.mesh), scene_(scene), options_(options) {}

    std::vector<cl_float4> render() {
        const size_t pixels = size_t(options_.width) * options_.height;
        const auto [rays, hits] = test::rasterize(scene_, options_);
        std::vector<cl_float4> colour = wave(rays, hits, {}, 0);
        for (size_t i = 0; i < pixels; ++i)
            colour[i].s[3] = hits[i].primitive == RSH_NO_HIT ? 0.0f : 1.0f;
        return colour;
    }

    // By bounce: of what rsh_statistics counts.
    std::vector<cl_ulong> spawned_rays = std::vector<cl_ulong>(RSH_MAX_LEVELS + 1);
    std::vector<cl_ulong> shadow_rays = std::vector<cl_ulong>(RSH_MAX_LEVELS + 1);

private:
    std::vector<cl_float4> wave(const test::Rays& rays, const std::vector<rsh_hit>& hits,
                                const std::vector<cl_float4>& weights, uint32_t depth) {
        std::vector<cl_float4> colour(hits.size(), cl_float4{{0, 0, 0, 0}});
        colour =
            test::shade(scene_, rays.rays, hits, colour, weights, shadows(rays, hits, depth));
        if (depth == options_.bounces) return colour;
        for (const uint32_t kind : {RSH_SPAWN_REFLECTION, RSH_SPAWN_REFRACTION}) {
            test::SpawnOptions spawn;
            spawn.kind = kind;
            spawn.weights = weights;
            spawn.min_weight = options_.min_weight;
            const auto spawned = test::spawn(scene_, rays.rays, hits, spawn);
            if (spawned.active == 0) continue;
            spawned_rays[depth + 1] += spawned.active;
            const test::Rays next = {spawned.rays, rays.width, rays.height, spawned.skip};
            const auto seen = wave(next, closest_hits(mesh_, next), spawned.weights, depth + 1);
            for (size_t i = 0; i < seen.size(); ++i)
                for (int c = 0; c < 3; ++c) colour[i].s[c] += seen[i].s[c];
        }
        return colour;
    }

    std::vector<uint32_t> shadows(const test::Rays& rays, const std::vector<rsh_hit>& hits,
                                  uint32_t depth) {
        std::vector<uint32_t> masks(rays.rays.size(), 0);
        for (uint32_t light = 0; light < scene_.desc.light_count; ++light) {
            if (!(scene_.desc.shadow_lights >> light & 1)) continue;
            test::SpawnOptions spawn;
            spawn.kind = RSH_SPAWN_SHADOW;
            spawn.light = light;
            const auto spawned = test::spawn(scene_, rays.rays, hits, spawn);
            shadow_rays[depth] += spawned.active;
            masks = occlusion(mesh_, {spawned.rays, rays.width, rays.height, spawned.skip},
                              masks, light);
        }
        return masks;
    }

    test::DeviceMesh mesh_;
    test::DeviceScene scene_;
    FrameOptions options_;
};

TEST(Frame, EqualsTheLoopOfThePublicCalls) {
    for (uint32_t bounces = 0; bounces <= 3; ++bounces) {
        FrameOptions options = sized(80, 60, bounces);
        options.min_weight = 0.01f;
        SCOPED_TRACE("bounces " + std::to_string(bounces));
        const auto image = test::frame(test::DeviceScene(test::gallery()), options);
        EXPECT_TRUE(
            test::same_bits(image, HandRolled(test::gallery(), options).render(), "pixels"));
    }
}

// A ball of glass before the eye: most rays go on twice, more than a frame has room for.
Scene ball_of_glass() {
    Scene scene;
    scene.mesh = test::sphere(24, 11);
    rsh_material glass = test::matte({0.1f, 0.1f, 0.1f});
    glass.transmission = {{0.9f, 0.95f, 1, 1.5f}};
    scene.materials = {glass};
    scene.lights = {test::directional_light({0.3f, -0.8f, -0.5f}, {1, 1, 1})};
    scene.environment = {0.25f, 0.5f, 0.75f};
    return scene;
}

TEST(Frame, EqualsTheLoopWhereAWaveIsTakenInParts) {
    const test::OwnContext context;
    FrameOptions options = sized(37, 29, 4);
    const rsh_camera camera =
        test::look_at({0.1f, 0.2f, 1.3f}, {0, 0, 0}, options.width, options.height);
    options.camera = &camera;
    options.context = context.get();
    RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
    const auto image = test::frame(test::DeviceScene(ball_of_glass()), options);
    EXPECT_TRUE(
        test::same_bits(image, HandRolled(ball_of_glass(), options).render(), "pixels"));
    rsh_statistics s = {};
    s.struct_size = sizeof s;
    RSH_CHECK(rsh_get_statistics(context.get(), &s));
    EXPECT_GT(s.traversals, 1u + 2 * options.bounces) << "no wave was taken in parts";
}

TEST(Frame, CountsTheRaysOfItsWaves) {
    const test::OwnContext context;
    FrameOptions options = sized(64, 48, 2);
    HandRolled loop(test::gallery(), options);
    loop.render();
    options.context = context.get();
    RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
    test::frame(test::DeviceScene(test::gallery()), options);
    rsh_statistics s = {};
    s.struct_size = sizeof s;
    RSH_CHECK(rsh_get_statistics(context.get(), &s));
    EXPECT_GT(s.shadow_rays[0], 0u);
    for (uint32_t bounce = 0; bounce <= RSH_MAX_LEVELS; ++bounce) {
        SCOPED_TRACE("bounce " + std::to_string(bounce));
        EXPECT_EQ(s.shadow_rays[bounce], loop.shadow_rays[bounce]);
        if (bounce > 0) {
            EXPECT_EQ(s.active_rays[bounce], loop.spawned_rays[bounce]);
        }
    }
}

TEST(Frame, GivesTheSameBytesTwiceInAnySize) {
    const test::DeviceScene scene(test::gallery());
    const uint32_t shapes[][2] = {{1, 1}, {1, 37}, {41, 1}, {64, 64}, {321, 241}, {1021, 769}};
    for (const auto& shape : shapes) {
        const FrameOptions options = sized(shape[0], shape[1], 1);
        SCOPED_TRACE(std::to_string(options.width) + " x " + std::to_string(options.height));
        const auto image = test::frame(scene, options);
        expect_finite(image);
        EXPECT_TRUE(test::same_bits(test::frame(scene, options), image, "pixels"));
    }
}

// Every vertex by its own step. Seldom far enough for bounds to be made anew.
Scene moved(Scene scene, float step, uint64_t salt) {
    test::Random random(salt);
    for (test::Float3& v : scene.mesh.vertices) v = v + step * random.direction();
    return scene;
}

TEST(Frame, GivesTheSameBytesWithBoundsThatItRefits) {
    const FrameOptions options = sized(72, 56, 2);
    const test::DeviceScene first(test::gallery());
    for (const test::TraceOptions& way : test::all_ways()) {
        SCOPED_TRACE(name_of(way));
        test::KeptFrames kept(way.engine, first.desc.geometry);
        for (const float step : {0.0f, 0.0f, 0.002f, 0.02f, 0.5f, 0.0f}) {
            const test::DeviceScene scene(moved(test::gallery(), step, 40));
            FrameOptions own = options;
            own.own_scratch = step > 0;
            EXPECT_TRUE(
                test::same_bits(kept.render(scene, own), test::frame(scene, options), "pixels"))
                << "step " << step;
        }
    }
}

TEST(Frame, GivesTheSameBytesWithEveryEngineStrategyAndBudget) {
    const test::DeviceScene scene(test::gallery());
    FrameOptions options = sized(72, 56, 2);
    options.engine = RSH_ENGINE_BRUTE_FORCE;
    const auto expected = test::frame(scene, options);
    for (options.engine = 1; rsh_engine_name(options.engine); ++options.engine)
        EXPECT_TRUE(test::same_bits(test::frame(scene, options), expected, "pixels"))
            << rsh_engine_name(options.engine);
    options.engine = RSH_ENGINE_PAPER_FAITHFUL;
    for (const cl_uint strategy : test::all_strategies())
        for (const bool is_least : {false, true}) {
            options.strategy = strategy;
            options.own_scratch = is_least;
            options.budget = is_least ? test::least_budget(scene, options) : 0;
            EXPECT_TRUE(test::same_bits(test::frame(scene, options), expected, "pixels"))
                << rsh_strategy_name(strategy) << ", budget " << options.budget;
        }
}

TEST(Frame, StaysFiniteAfterManyBounces) {
    expect_finite(test::frame(test::DeviceScene(test::gallery()), sized(48, 36, 6)));
}

TEST(Frame, WithoutShadowsEqualsAFrameOfLightsThatCastNone) {
    Scene lit = test::gallery();
    for (rsh_light& light : lit.lights) light.casts_shadow = 0;
    const FrameOptions options = sized(64, 48, 1);
    EXPECT_TRUE(test::same_bits(
        test::frame(test::DeviceScene(test::gallery(), RSH_FEATURE_SHADOW), options),
        test::frame(test::DeviceScene(lit), options), "pixels"));
}

TEST(Frame, WithoutTexturesEqualsAFrameOfMaterialsThatHaveNone) {
    Scene bare = test::gallery();
    bare.materials[0].texture = RSH_NO_TEXTURE;
    const FrameOptions options = sized(64, 48, 1);
    EXPECT_TRUE(test::same_bits(
        test::frame(test::DeviceScene(test::gallery(), RSH_FEATURE_TEXTURE), options),
        test::frame(test::DeviceScene(bare), options), "pixels"));
}

TEST(Frame, WithoutSmoothNormalsEqualsAFrameOfAFlatScene) {
    Scene flat = test::gallery();
    flat.normals.clear();
    const FrameOptions options = sized(64, 48, 1);
    EXPECT_TRUE(test::same_bits(
        test::frame(test::DeviceScene(test::gallery(), RSH_FEATURE_SMOOTH_NORMAL), options),
        test::frame(test::DeviceScene(flat), options), "pixels"));
}

TEST(Frame, WithoutReflectionEqualsAFrameOfMattes) {
    Scene opaque = test::gallery(), matte;
    opaque.materials[2] = test::matte({0.3f, 0.3f, 0.3f});
    matte = opaque;
    matte.materials[1].reflection = {{0, 0, 0, 0}};
    const FrameOptions options = sized(64, 48, 2);
    EXPECT_TRUE(
        test::same_bits(test::frame(test::DeviceScene(opaque, RSH_FEATURE_REFLECTION), options),
                        test::frame(test::DeviceScene(matte), options), "pixels"));
}

TEST(Frame, OfAPlainSceneEqualsOneWithAllFeaturesOn) {
    const FrameOptions options = sized(64, 48, 2);
    test::DeviceScene lean(test::plain()), full(test::plain());
    EXPECT_EQ(lean.desc.features, 0u);
    full.desc.features = RSH_FEATURE_REFLECTION | RSH_FEATURE_REFRACTION | RSH_FEATURE_SHADOW;
    EXPECT_TRUE(
        test::same_bits(test::frame(full, options), test::frame(lean, options), "pixels"));
}

TEST(Frame, ShowsTheEnvironmentWhereThereIsNothing) {
    Scene scene = test::plain();
    scene.mesh = test::Mesh();
    scene.environment = {0.25f, 0.5f, 0.75f};
    for (const cl_float4& pixel : test::frame(test::DeviceScene(scene), sized(40, 30, 2))) {
        ASSERT_EQ(pixel.s[0], 0.25f);
        ASSERT_EQ(pixel.s[1], 0.5f);
        ASSERT_EQ(pixel.s[2], 0.75f);
        ASSERT_EQ(pixel.s[3], 0);
    }
}

TEST(Frame, LaunchesNothingForFeaturesThatTheSceneLacks) {
    const test::OwnContext context;
    FrameOptions options = sized(64, 48, 3);
    options.context = context.get();
    RSH_CHECK(rsh_count_statistics(context.get(), CL_TRUE));
    test::frame(test::DeviceScene(test::plain()), options);
    rsh_statistics s = {};
    s.struct_size = sizeof s;
    RSH_CHECK(rsh_get_statistics(context.get(), &s));
    EXPECT_EQ(s.traversals, 0u)
        << "a matte scene without shadows needs no ray but the primary ones";
    EXPECT_EQ(s.host_waits, 0u);
    EXPECT_EQ(s.shadow_rays[0], 0u);
    EXPECT_GT(s.active_rays[0], 0u);
}

}  // namespace
