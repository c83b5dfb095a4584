// glass_test.cpp - whatever number stands for an index of refraction, the light that meets glass
// goes on: mirrored, refracted or both, in finite shares.
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <limits>

#include "support/compare.hpp"
#include "support/render.hpp"
#include "support/trace.hpp"

namespace {

using test::Double3;
using test::Float3;
using test::Scene;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const float kNan = std::numeric_limits<float>::quiet_NaN();

const std::vector<float>& indices() {
    static const std::vector<float> all = {
        1e-45f, 1e-40f, 1.1e-38f, 1e-30f, 1e-20f, 1e-18f,    1e-10f,    0.5f,
        1.0f,   1.5f,   1e10f,    1e18f,  1e20f,  1e30f,     FLT_MAX,   0.0f,
        -0.0f,  -1.0f,  -1.5f,    -1e30f, kNan,   kInfinity, -kInfinity};
    return all;
}

// Those are no indices, and count as 1.
bool is_index(float index) {
    return index > 0 && std::isfinite(index);
}

// A ball of nothing but glass.
Scene ball(float index) {
    Scene scene;
    scene.mesh = test::sphere(24, 11);
    rsh_material glass = test::matte({0, 0, 0});
    glass.transmission = {{1, 1, 1, index}};
    scene.materials = {glass};
    scene.environment = {1, 1, 1};
    scene.ambient = {0, 0, 0};
    return scene;
}

// Half of them from inside.
test::Rays rays_at_ball() {
    test::Random random(330);
    const uint32_t count = test::small() ? 40 : 1000;
    test::Rays rays{{}, count, 1};
    for (uint32_t i = 0; i < count; ++i) {
        const Float3 eye = i % 2 ? random.in_cube(0.4f) : 3.0f * normalize(random.direction());
        const Float3 at = i % 2 ? eye + random.direction() : random.in_cube(0.5f);
        rays.rays.push_back(test::make_ray(eye, at - eye));
    }
    return rays;
}

// What goes on one way; active rays only, others weigh nothing.
void expect_sound(const rsh_ray& ray, const cl_float4& weight) {
    for (int axis = 0; axis < 3; ++axis)
        ASSERT_TRUE(weight.s[axis] >= 0 && weight.s[axis] <= 1 + 1e-5f) << weight;
    if (!test::is_active(ray)) {
        ASSERT_EQ(weight.s[0], 0);
        return;
    }
    ASSERT_NEAR(length(Double3(test::direction(ray))), 1, 1e-6);
}

TEST(Glass, LetsAllLightGoOnWhateverItsIndex) {
    const test::Rays rays = rays_at_ball();
    const auto hits = closest_hits(test::DeviceMesh(ball(1).mesh), rays);
    for (const float index : indices()) {
        SCOPED_TRACE("index " + std::to_string(index));
        const test::DeviceScene scene(ball(index));
        test::SpawnOptions options;
        const auto mirrored = test::spawn(scene, rays.rays, hits, options);
        options.kind = RSH_SPAWN_REFRACTION;
        const auto refracted = test::spawn(scene, rays.rays, hits, options);
        for (size_t i = 0; i < hits.size(); ++i) {
            if (hits[i].primitive == RSH_NO_HIT) continue;
            SCOPED_TRACE("ray " + std::to_string(i));
            ASSERT_NO_FATAL_FAILURE(expect_sound(mirrored.rays[i], mirrored.weights[i]));
            ASSERT_NO_FATAL_FAILURE(expect_sound(refracted.rays[i], refracted.weights[i]));
            ASSERT_TRUE(test::is_active(mirrored.rays[i]) ||
                        test::is_active(refracted.rays[i]));
            ASSERT_NEAR(mirrored.weights[i].s[0] + refracted.weights[i].s[0], 1, 1e-5);
            if (is_index(index)) continue;
            const Double3 straight = normalize(Double3(test::direction(rays.rays[i])));
            ASSERT_LT(max_norm(Double3(test::direction(refracted.rays[i])) - straight), 1e-5)
                << refracted.rays[i];
        }
    }
}

// In glass that nothing enters, or nothing leaves, all light is mirrored.
TEST(Glass, OfAnExtremeIndexIsAMirror) {
    const test::Rays rays = rays_at_ball();
    const auto hits = closest_hits(test::DeviceMesh(ball(1).mesh), rays);
    for (const float index : {1e-40f, 1e-30f, 1e-20f, 1e20f, 1e30f}) {
        const auto mirrored = test::spawn(test::DeviceScene(ball(index)), rays.rays, hits, {});
        for (size_t i = 0; i < hits.size(); ++i) {
            const float expected = hits[i].primitive == RSH_NO_HIT ? 0 : 1;
            ASSERT_NEAR(mirrored.weights[i].s[0], expected, 1e-5)
                << "index " << index << ", ray " << i;
        }
    }
}

// Under a sky of 1 a ball is as bright as the sky, less what still goes round in it after the last
// bounce: 0.02 at 1.5, nothing far from 1.
TEST(Glass, IsAsBrightAsTheSky) {
    for (const float index : indices()) {
        test::FrameOptions options;
        options.width = test::small() ? 8 : 48;
        options.height = options.width;
        options.bounces = 8;
        const rsh_camera camera =
            test::look_at({0, 0.3f, 3}, {0, 0, 0}, options.width, options.height);
        options.camera = &camera;
        const auto picture = test::frame(test::DeviceScene(ball(index)), options);
        double sum = 0;
        for (size_t i = 0; i < picture.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                ASSERT_TRUE(picture[i].s[c] >= 0 && picture[i].s[c] < 1 + 1e-4f)
                    << "index " << index << ", pixel " << i << " " << picture[i];
                sum += double(picture[i].s[c]) / 3;
            }
        EXPECT_GT(sum / double(picture.size()), 0.97) << "index " << index;
    }
}

}  // namespace
