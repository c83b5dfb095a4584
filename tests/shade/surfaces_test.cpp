// surfaces_test.cpp - rsh_find_surfaces against the surfaces of the oracle, and rsh_shade.
#include <gtest/gtest.h>

#include <optional>

#include "oracle/whitted.hpp"
#include "support/compare.hpp"
#include "support/render.hpp"
#include "support/trace.hpp"

namespace {

using test::Buffer;
using test::device;
using test::DeviceScene;
using test::Double3;
using test::Scene;

// Rays from outside and from inside of the glass, some inactive, with their hits.
struct Sight {
    std::vector<rsh_ray> rays;
    std::vector<rsh_hit> hits;
};

Sight look(const Scene& scene) {
    const uint32_t width = test::small() ? 16 : 96, height = test::small() ? 12 : 72;
    test::Rays rays = test::pinhole_rays(width, height, {0.4f, 2.2f, 5.5f}, {0, 0.8f, 0}, 3);
    test::Random random(30);
    for (size_t i = 0; i < rays.rays.size(); i += 3)
        rays.rays[i] = test::make_ray(test::Float3(1.2f, 0.9f, 1) + random.in_cube(0.4f),
                                      random.direction());
    rays.rays[7] = test::inactive_ray();
    return {rays.rays, closest_hits(test::DeviceMesh(scene.mesh), rays)};
}

struct Options {
    std::optional<uint32_t> list_count = {};
    rsh_features without = 0;
    rsh_context context = nullptr;  // null: the device's
};

std::vector<rsh_surface> find(const Scene& scene, const Sight& sight, const Options& options) {
    const DeviceScene on_device(scene, options.without);
    const Buffer<rsh_ray> rays(sight.rays);
    const Buffer<rsh_hit> hits(sight.hits);
    const Buffer<rsh_surface> surfaces(sight.rays.size());
    const Buffer<uint32_t> count(std::vector<uint32_t>{options.list_count.value_or(0)});
    rsh_find_surfaces_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.scene = &on_device.desc;
    desc.ray_count = cl_uint(sight.rays.size());
    desc.rays = rays.get();
    desc.hits = hits.get();
    desc.surfaces = surfaces.get();
    if (options.list_count) desc.list_count = count.get();
    const rsh_context context = options.context ? options.context : device().rsh;
    RSH_CHECK(rsh_find_surfaces(context, device().queue(), &desc, 0, nullptr, nullptr));
    EXPECT_TRUE(surfaces.guards_intact());
    return surfaces.read();
}

double distance(const rsh_float4& actual, Double3 expected) {
    return max_norm(Double3(actual.s[0], actual.s[1], actual.s[2]) - expected);
}

bool is_active(const rsh_ray& ray) {
    return ray.direction_tmax.s[3] >= ray.origin_tmin.s[3];
}

void expect_none(const rsh_surface& surface) {
    rsh_surface none = {};
    none.primitive = RSH_NO_HIT;
    EXPECT_TRUE(test::same_bits(std::vector<rsh_surface>{surface}, {none}, "surfaces"));
}

TEST(Surfaces, AreThoseOfTheOracle) {
    const Scene scene = test::gallery();
    const Sight sight = look(scene);
    const auto surfaces = find(scene, sight, {});
    size_t inside = 0;
    for (size_t i = 0; i < surfaces.size(); ++i) {
        SCOPED_TRACE("ray " + std::to_string(i));
        const rsh_surface& actual = surfaces[i];
        const rsh_hit& hit = sight.hits[i];
        if (hit.primitive == RSH_NO_HIT || !is_active(sight.rays[i])) {
            expect_none(actual);
            continue;
        }
        const oracle::Surface expected = oracle::surface_at(scene, sight.rays[i], hit);
        inside += expected.from_inside;
        ASSERT_LT(distance(actual.point, expected.point), 1e-5);
        ASSERT_EQ(actual.point.s[3], hit.t);
        ASSERT_LT(distance(actual.geometric, expected.geometric), 1e-5);
        ASSERT_EQ(actual.geometric.s[3], expected.from_inside ? -1.0f : 1.0f);
        ASSERT_LT(distance(actual.normal, expected.normal), 1e-4);
        ASSERT_EQ(actual.material, scene.material_ids[hit.primitive]);
        ASSERT_EQ(actual.primitive, hit.primitive);
        const uint32_t texture = scene.materials[actual.material].texture;
        ASSERT_LT(
            distance(actual.texture, texture == RSH_NO_TEXTURE
                                         ? Double3(1, 1, 1)
                                         : oracle::texture_at(scene, texture, actual.texture_u,
                                                              actual.texture_v)),
            1e-4);
        ASSERT_NEAR(actual.texture_u, 0.4 * expected.point.x, 1e-5);
        ASSERT_NEAR(actual.texture_v, 0.4 * expected.point.z, 1e-5);
    }
    EXPECT_GT(inside, 0u);
}

// Under white ambient light alone rsh_shade gives the texture's colour.
TEST(Surfaces, HaveTheBitsOfShading) {
    Scene scene = test::gallery();
    scene.lights.clear();
    scene.ambient = {1, 1, 1};
    scene.environment = {0, 0, 0};
    for (rsh_material& material : scene.materials) {
        material.ambient = {{1, 1, 1, 0}};
        material.emission = {};
    }
    const Sight sight = look(scene);
    const auto surfaces = find(scene, sight, {});
    const auto colour =
        test::shade(DeviceScene(scene), sight.rays, sight.hits,
                    std::vector<cl_float4>(sight.rays.size(), cl_float4{{0, 0, 0, 0}}));
    std::vector<cl_float4> textures;
    for (const rsh_surface& surface : surfaces) textures.push_back(surface.texture);
    EXPECT_TRUE(test::same_bits(textures, colour, "colours"));
}

TEST(Surfaces, AreTheSameBitsAtEveryWidth) {
    const Scene scene = test::gallery();
    const Sight sight = look(scene);
    const auto expected = find(scene, sight, {});
    for (const cl_uint width : {1u, 4u, 8u, 16u}) {
        const test::OwnContext context(width);
        Options options;
        options.context = context.get();
        EXPECT_TRUE(test::same_bits(find(scene, sight, options), expected, "surfaces"))
            << width;
    }
}

TEST(Surfaces, AreFlatAndPlainWithoutTheFeatures) {
    const Scene scene = test::gallery();
    const Sight sight = look(scene);
    Options options;
    options.without = RSH_FEATURE_SMOOTH_NORMAL | RSH_FEATURE_TEXTURE;
    for (const rsh_surface& surface : find(scene, sight, options)) {
        if (surface.primitive == RSH_NO_HIT) continue;
        for (int c = 0; c < 3; ++c) {
            ASSERT_EQ(surface.normal.s[c], surface.geometric.s[c]);
            ASSERT_EQ(surface.texture.s[c], 1.0f);
        }
    }
}

// Hits need not be rsh's: a triangle that is not there, one with an index out of range, one without
// area.
TEST(Surfaces, AreNoneWhereThereIsNoTriangle) {
    Scene scene = test::plain();
    const auto triangles = scene.mesh.triangle_count();
    scene.mesh.indices.insert(scene.mesh.indices.end(), {0, 1, 0xffffffffu, 0, 1, 1});
    scene.material_ids.clear();
    Sight sight = look(scene);
    const cl_uint none[] = {triangles, triangles + 1, triangles + 2, 0x7fffffffu};
    for (size_t i = 0; i < 40; ++i) sight.hits[i] = {1, 0.25f, 0.5f, none[i % 4]};
    const auto surfaces = find(scene, sight, {});
    for (size_t i = 0; i < 40; ++i) expect_none(surfaces[i]);
}

TEST(Surfaces, AreThoseOfAListOfThatLength) {
    const Scene scene = test::gallery();
    const Sight sight = look(scene);
    const auto all = find(scene, sight, {});
    const uint32_t length = uint32_t(all.size());
    for (const uint32_t count : {0u, 1u, length / 2 + 5, length + 1}) {
        Options options;
        options.list_count = count;
        auto expected = Buffer<rsh_surface>(length).read();
        std::copy_n(all.begin(), std::min(count, length), expected.begin());
        EXPECT_TRUE(test::same_bits(find(scene, sight, options), expected, "surfaces"))
            << count;
    }
}

}  // namespace
