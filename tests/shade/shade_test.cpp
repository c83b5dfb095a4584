// shade_test.cpp - rsh_shade and rsh_spawn against Whitted's sums in double precision.
#include <gtest/gtest.h>

#include "oracle/whitted.hpp"
#include "support/compare.hpp"
#include "support/render.hpp"
#include "support/trace.hpp"

namespace {

using test::Double3;
using test::Float3;
using test::Scene;

// Rays from outside and from inside of the glass, with their hits.
struct Sight {
    std::vector<rsh_ray> rays;
    std::vector<rsh_hit> hits;
};

Sight look(const Scene& scene) {
    const uint32_t width = test::small() ? 16 : 96, height = test::small() ? 12 : 72;
    test::Rays rays = test::pinhole_rays(width, height, {0.4f, 2.2f, 5.5f}, {0, 0.8f, 0}, 3);
    test::Random random(30);
    for (size_t i = 0; i < rays.rays.size(); i += 3)
        rays.rays[i] =
            test::make_ray(Float3(1.2f, 0.9f, 1) + random.in_cube(0.4f), random.direction());
    return {rays.rays, closest_hits(test::DeviceMesh(scene.mesh), rays)};
}

std::vector<cl_float4> black(size_t count) {
    return std::vector<cl_float4>(count, cl_float4{{0, 0, 0, 0.25f}});
}

::testing::AssertionResult near(const cl_float4& actual, Double3 expected, double tolerance) {
    const Double3 difference = Double3(actual.s[0], actual.s[1], actual.s[2]) - expected;
    if (max_norm(difference) <= tolerance * (1 + max_norm(expected)))
        return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "actual " << actual << ", expected " << expected.x
                                         << ", " << expected.y << ", " << expected.z;
}

// Where a light grazes the surface or its spot's rim, or the texel at a fold of the
// environment, float and double may decide differently: such rays are too few to hide an error.
void expect_shaded(const Scene& scene, const std::vector<uint32_t>& hidden = {}) {
    const Sight sight = look(scene);
    std::vector<uint32_t> masks = hidden;
    if (!masks.empty()) masks.resize(sight.rays.size(), hidden[0]);
    const auto colour = test::shade(test::DeviceScene(scene), sight.rays, sight.hits,
                                    black(sight.rays.size()), {}, masks);
    size_t wrong = 0;
    std::string first;
    for (size_t i = 0; i < colour.size(); ++i) {
        ASSERT_EQ(colour[i].s[3], 0.25f)
            << "alpha of ray " << i << " is not rsh_shade's to write";
        const Double3 expected = oracle::radiance(scene, sight.rays[i], sight.hits[i],
                                                  hidden.empty() ? 0 : masks[i]);
        const auto result = near(colour[i], expected, 1e-3);
        if (!result && wrong++ == 0)
            first = "ray " + std::to_string(i) + ", primitive " +
                    std::to_string(sight.hits[i].primitive) + ": " + result.message();
    }
    EXPECT_LE(wrong, colour.size() / 500) << wrong << " rays are wrong, first " << first;
}

TEST(Shade, SumsEmissionAmbientDiffuseAndHighlights) {
    expect_shaded(test::plain());
}

TEST(Shade, MatchesWhittedInTheGallery) {
    expect_shaded(test::gallery());
}

TEST(Shade, LeavesOutHiddenLights) {
    for (const uint32_t mask : {1u, 2u, 4u, 7u}) {
        SCOPED_TRACE("mask " + std::to_string(mask));
        expect_shaded(test::gallery(), {mask});
    }
}

TEST(Shade, MatchesWhittedForEachLightAlone) {
    const Scene all = test::gallery();
    for (size_t k = 0; k < all.lights.size(); ++k) {
        SCOPED_TRACE("light " + std::to_string(k));
        Scene one = all;
        one.lights = {all.lights[k]};
        expect_shaded(one);
    }
}

TEST(Shade, ReadsFloatTexturesOutsideOfTheUnitSquare) {
    Scene scene = test::gallery();
    scene.materials[0].texture = scene.environment_texture - 1;
    for (auto& uv : scene.texcoords) uv = {1.7f * uv[0] - 3, 0.9f * uv[1] + 5};
    expect_shaded(scene);
}

TEST(Shade, ShowsTheEdgeOfClampedTexturesOutsideOfTheUnitSquare) {
    Scene scene = test::gallery();
    scene.textures.push_back(scene.textures[scene.environment_texture - 1]);
    scene.textures.back().wrap = RSH_WRAP_CLAMP;
    scene.materials[0].texture = static_cast<cl_uint>(scene.textures.size() - 1);
    for (auto& uv : scene.texcoords) uv = {1.7f * uv[0] - 0.5f, 2.9f * uv[1] - 1};
    expect_shaded(scene);
    for (auto& texture : scene.textures) texture.wrap = RSH_WRAP_CLAMP;
    for (auto& uv : scene.texcoords) uv = {uv[0] - 7, uv[1] + 5};
    scene.environment_texture = 0;
    expect_shaded(scene);
}

TEST(Shade, RepeatsTheEnvironmentWhateverItsTextureSays) {
    const Scene scene = test::gallery();
    const Sight sight = look(scene);
    const auto colours = [&](cl_uint wrap) {
        Scene changed = scene;
        changed.textures[scene.environment_texture - 1].wrap = wrap;
        return test::shade(test::DeviceScene(changed), sight.rays, sight.hits,
                           black(sight.rays.size()));
    };
    EXPECT_TRUE(test::same_bits(colours(RSH_WRAP_CLAMP), colours(RSH_WRAP_REPEAT), "colours"));
}

// In the same buffer, three floats of each first, then the next vertex.
TEST(Shade, ReadsNormalsThatLieBetweenTheVertices) {
    const Scene scene = test::gallery();
    const Sight sight = look(scene);
    const test::DeviceScene packed(scene);
    std::vector<Float3> both(1);
    for (size_t i = 0; i < scene.normals.size(); ++i)
        both.insert(both.end(), {scene.mesh.vertices[i], scene.normals[i]});
    const test::Buffer<Float3> buffer(both);
    test::DeviceScene interleaved(scene);
    rsh_scene& desc = interleaved.desc;
    desc.geometry.vertices = desc.normals = buffer.get();
    desc.geometry.vertex_stride = desc.normal_stride = 2 * sizeof(Float3);
    desc.geometry.vertices_offset = sizeof(Float3);
    desc.normals_offset = 2 * sizeof(Float3);
    EXPECT_TRUE(test::same_bits(
        test::shade(interleaved, sight.rays, sight.hits, black(sight.rays.size())),
        test::shade(packed, sight.rays, sight.hits, black(sight.rays.size())), "colours"));
    EXPECT_TRUE(test::same_bits(test::spawn(interleaved, sight.rays, sight.hits, {}).rays,
                                test::spawn(packed, sight.rays, sight.hits, {}).rays, "rays"));
}

TEST(Shade, TakesMaterialZeroForAnIdOutOfRange) {
    Scene scene = test::plain();
    scene.material_ids.assign(scene.mesh.triangle_count(), 77);
    expect_shaded(scene);
}

TEST(Shade, ScalesByTheWeightAndAddsToTheColour) {
    const Scene scene = test::gallery();
    const Sight sight = look(scene);
    const test::DeviceScene on_device(scene);
    const size_t n = sight.rays.size();
    const std::vector<cl_float4> weights(n, cl_float4{{0.5f, 0.25f, 2, 0}});
    const std::vector<cl_float4> start(n, cl_float4{{1, 2, 3, 4}});
    const auto once = test::shade(on_device, sight.rays, sight.hits, black(n));
    const auto weighted = test::shade(on_device, sight.rays, sight.hits, start, weights);
    for (size_t i = 0; i < n; ++i) {
        const auto& c = once[i].s;
        ASSERT_TRUE(near(weighted[i], {1 + 0.5 * c[0], 2 + 0.25 * c[1], 3 + 2.0 * c[2]}, 1e-5))
            << "ray " << i;
        ASSERT_EQ(weighted[i].s[3], 4);
    }
}

TEST(Shade, LeavesTheColourOfInactiveRaysAlone) {
    const Scene scene = test::gallery();
    std::vector<rsh_ray> rays(100, test::inactive_ray());
    rsh_hit none = {};
    none.primitive = RSH_NO_HIT;
    const auto start = std::vector<cl_float4>(100, cl_float4{{1, 2, 3, 4}});
    EXPECT_TRUE(test::same_bits(
        test::shade(test::DeviceScene(scene), rays, std::vector<rsh_hit>(100, none), start),
        start, "colours"));
}

// Weight, direction, origin and side of every spawned ray.
void expect_spawned(uint32_t kind) {
    const Scene scene = test::gallery();
    const Sight sight = look(scene);
    test::SpawnOptions options;
    options.kind = kind;
    const auto spawned = test::spawn(test::DeviceScene(scene), sight.rays, sight.hits, options);
    uint32_t active = 0;
    size_t disagree = 0;
    for (size_t i = 0; i < sight.rays.size(); ++i) {
        const bool exists = test::is_active(spawned.rays[i]);
        active += exists;
        oracle::Secondary expected;
        oracle::Surface surface;
        if (sight.hits[i].primitive != RSH_NO_HIT) {
            surface = oracle::surface_at(scene, sight.rays[i], sight.hits[i]);
            expected = kind == RSH_SPAWN_REFLECTION ? oracle::reflected(surface, sight.rays[i])
                                                    : oracle::refracted(surface, sight.rays[i]);
        }
        // Around the critical angle float and double may disagree.
        if (exists != expected.exists) {
            ++disagree;
            continue;
        }
        if (!exists) continue;
        const Double3 d = normalize(Double3(test::direction(spawned.rays[i])));
        const Double3 moved = Double3(test::origin(spawned.rays[i])) - surface.point;
        ASSERT_LT(max_norm(d - expected.direction), 2e-3) << "ray " << i;
        ASSERT_TRUE(near(spawned.weights[i], expected.weight, 2e-3)) << "weight of ray " << i;
        ASSERT_LT(length(moved), 1e-4) << "origin of ray " << i;
    }
    EXPECT_EQ(spawned.active, active) << "the count on the device";
    EXPECT_GT(active, 0u);
    EXPECT_LE(disagree, sight.rays.size() / 500);
}

TEST(Spawn, ReflectsAboutTheShadingNormal) {
    expect_spawned(RSH_SPAWN_REFLECTION);
}

TEST(Spawn, RefractsBySnellAndWeighsByFresnel) {
    expect_spawned(RSH_SPAWN_REFRACTION);
}

// Those that are not told which one it is.
TEST(Spawn, KeepsRaysOffTheirTriangleByDistance) {
    for (const float scale : {1e-6f, 1.0f, 1e6f}) {
        Scene scene = test::gallery();
        scene.mesh = test::scaled(scene.mesh, scale);
        Sight sight = look(scene);
        test::Rays rays =
            test::scaled(test::Rays{sight.rays, uint32_t(sight.rays.size()), 1}, scale);
        sight.rays = rays.rays;
        sight.hits = closest_hits(test::DeviceMesh(scene.mesh), rays);
        for (const uint32_t kind : {RSH_SPAWN_REFLECTION, RSH_SPAWN_REFRACTION}) {
            test::SpawnOptions options;
            options.kind = kind;
            options.by_distance = true;
            const auto spawned =
                test::spawn(test::DeviceScene(scene), sight.rays, sight.hits, options);
            const auto hits = closest_hits(test::DeviceMesh(scene.mesh),
                                           {spawned.rays, uint32_t(spawned.rays.size()), 1});
            for (size_t i = 0; i < hits.size(); ++i)
                ASSERT_FALSE(hits[i].primitive != RSH_NO_HIT &&
                             hits[i].primitive == sight.hits[i].primitive)
                    << "scale " << scale << ", kind " << kind << ", ray " << i << " "
                    << spawned.rays[i];
        }
    }
}

TEST(Spawn, LeavesOutRaysThatWeighTooLittle) {
    const Scene scene = test::gallery();
    const Sight sight = look(scene);
    test::SpawnOptions options;
    options.weights.assign(sight.rays.size(), cl_float4{{0.5f, 0.25f, 0.125f, 0}});
    const auto all = test::spawn(test::DeviceScene(scene), sight.rays, sight.hits, options);
    options.min_weight = 0.2f;
    const auto heavy = test::spawn(test::DeviceScene(scene), sight.rays, sight.hits, options);
    for (size_t i = 0; i < all.rays.size(); ++i) {
        const auto& w = all.weights[i].s;
        const bool weighs = test::is_active(all.rays[i]) && std::max({w[0], w[1], w[2]}) > 0.2f;
        ASSERT_EQ(test::is_active(heavy.rays[i]), weighs) << "ray " << i;
    }
    EXPECT_LT(heavy.active, all.active);
}

// One shadow ray, where there is one, from the surface to the light.
void expect_shadow_ray(const rsh_light& light, const oracle::Surface& surface,
                       const rsh_ray& ray) {
    double distance;
    const Double3 l = oracle::towards_light(light, surface.point, &distance);
    ASSERT_LT(max_norm(normalize(Double3(test::direction(ray))) - l), 1e-3);
    ASSERT_EQ(ray.origin_tmin.s[3], 0);
    if (light.kind == RSH_LIGHT_DIRECTIONAL) {
        ASSERT_EQ(ray.direction_tmax.s[3], INFINITY);
        return;
    }
    const Double3 end = Double3(test::origin(ray)) + Double3(test::direction(ray));
    ASSERT_LT(length(end - (surface.point + distance * l)), 1e-3) << "t = 1 is not the light";
    ASSERT_EQ(ray.direction_tmax.s[3], 1 - 0x1p-16f);
}

void expect_shadow_rays(const Scene& scene, const Sight& sight, uint32_t k) {
    test::SpawnOptions options;
    options.kind = RSH_SPAWN_SHADOW;
    options.light = k;
    const auto spawned = test::spawn(test::DeviceScene(scene), sight.rays, sight.hits, options);
    size_t disagree = 0, active = 0;
    for (size_t i = 0; i < sight.rays.size(); ++i) {
        SCOPED_TRACE("ray " + std::to_string(i));
        const bool exists = test::is_active(spawned.rays[i]);
        active += exists;
        if (sight.hits[i].primitive == RSH_NO_HIT) {
            ASSERT_FALSE(exists);
            continue;
        }
        const auto surface = oracle::surface_at(scene, sight.rays[i], sight.hits[i]);
        disagree += exists !=
                    (scene.lights[k].casts_shadow && oracle::reaches(scene.lights[k], surface));
        if (exists) expect_shadow_ray(scene.lights[k], surface, spawned.rays[i]);
        if (::testing::Test::HasFatalFailure()) return;
    }
    EXPECT_LE(disagree, sight.rays.size() / 200);
    EXPECT_EQ(spawned.active, active);
    EXPECT_EQ(active > 0, scene.lights[k].casts_shadow == 1);
}

TEST(Spawn, CastsShadowRaysToTheLight) {
    Scene scene = test::gallery();
    const Sight sight = look(scene);
    for (const cl_uint casts : {0u, 1u}) {
        scene.lights[1].casts_shadow = casts;
        for (uint32_t k = 0; k < scene.lights.size(); ++k) {
            SCOPED_TRACE("light " + std::to_string(k));
            expect_shadow_rays(scene, sight, k);
        }
    }
}

}  // namespace
