// reference_frame_test.cpp - frames that have a formula, and rsh's own where nothing is near an edge.
#include "oracle/frame/reference_frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/render.hpp"

namespace {

using oracle::PathLimits;
using oracle::ReferencePixel;
using test::Double3;
using test::Float3;
using test::Scene;

std::vector<ReferencePixel> render(const Scene& scene, const oracle::View& view,
                                   const PathLimits& limits) {
    const oracle::SceneBvh bvh(scene.mesh);
    return oracle::ReferenceFrame(scene, bvh).render(view, limits);
}

oracle::View view(Float3 eye, Float3 at, uint32_t side) {
    return {test::look_at(eye, at, side, side), side, side};
}

rsh_material glossy(float emission, float reflection, float transmission, float index) {
    rsh_material m = test::matte({0, 0, 0});
    m.emission = {{emission, emission, emission, 0}};
    m.reflection = {{reflection, reflection, reflection, 0}};
    m.transmission = {{transmission, transmission, transmission, index}};
    return m;
}

// Of `material` alone, in the dark.
Scene body(const test::Mesh& mesh, const rsh_material& material) {
    Scene scene;
    scene.add(mesh, 0, nullptr);
    scene.materials = {material};
    scene.ambient = scene.environment = {0, 0, 0};
    return scene;
}

// Two squares, whose normals point away from what is between them.
test::Mesh slab() {
    test::Mesh mesh;
    for (const float z : {-0.5f, 0.5f})
        for (const float y : {-9.0f, 9.0f})
            for (const float x : {-9.0f, 9.0f}) mesh.vertices.push_back({x, y, z});
    mesh.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6};
    return mesh;
}

// A sky of two halves: 1 towards -z, 0 towards +z, where it has been for long near both.
void light_from_minus_z(Scene& scene) {
    std::vector<float> texels;
    for (const float value : {0.f, 0.f, 1.f, 1.f, 1.f, 1.f, 0.f, 0.f})
        texels.insert(texels.end(), {value, value, value, 1});
    scene.environment = {1, 1, 1};
    scene.environment_texture = 1 + scene.add_texture(8, 1, texels);
}

// In a closed room whose walls shine with 1 - r and mirror r, everything is 1 - r^(bounces + 1).
TEST(ReferenceFrame, OfAFurnaceIsAGeometricSum) {
    const double r = 0.75;
    const Scene scene = body(test::sphere(12, 7, 3), glossy(float(1 - r), float(r), 0, 1));
    for (const uint32_t bounces : {0u, 1u, 5u})
        for (const ReferencePixel& pixel :
             render(scene, view({0.2f, 0.3f, 0.1f}, {1, 0, 1}, 8), {bounces})) {
            EXPECT_NEAR(pixel.colour.x, 1 - std::pow(r, bounces + 1), 1e-12);
            EXPECT_NEAR(pixel.cut_weight, std::pow(r, bounces + 1), 1e-12);
        }
}

// The light that gets through a slab after 2 k reflections within has the weight (1 - F)^2 F^(2k).
TEST(ReferenceFrame, OfAGlassSlabIsAirysSum) {
    Scene scene = body(slab(), glossy(0, 0, 1, 1.5f));
    light_from_minus_z(scene);
    const oracle::View through = view({0.5f, 0.25f, 3}, {0, 0, 0}, 6);
    const auto pixels = render(scene, through, {7});
    for (uint32_t i = 0; i < pixels.size(); ++i) {
        const Double3 d = oracle::camera_ray(through, i % 6 + 0.5, i / 6 + 0.5).direction;
        const double cos_in = -d.z, cos_out = std::sqrt(1 - (1 - d.z * d.z) / (1.5 * 1.5));
        const double across = (cos_in - 1.5 * cos_out) / (cos_in + 1.5 * cos_out);
        const double along = (1.5 * cos_in - cos_out) / (1.5 * cos_in + cos_out);
        const double f = (across * across + along * along) / 2;
        double sum = 0;  // the ray in and out is 2 bounces, each pair of reflections 2 more
        for (int k = 0; 2 + 2 * k <= 7; ++k) sum += std::pow(1 - f, 2) * std::pow(f, 2 * k);
        EXPECT_NEAR(pixels[i].colour.x, sum, 1e-12) << "pixel " << i;
    }
}

// Where the mirrored ray of the ideal sphere goes; the triangles are off by their height.
TEST(ReferenceFrame, OfASphereOfManyTrianglesMirrorsAsTheSphere) {
    Scene scene = test::gallery();
    scene.mesh = test::sphere(256, 127);
    scene.normals = scene.mesh.vertices;
    scene.material_ids.clear();
    scene.texcoords.clear();
    scene.lights.clear();
    scene.materials = {glossy(0, 1, 0, 1)};
    const oracle::View towards = view({0, 0, 3}, {0, 0, 0}, 16);
    const auto pixels = render(scene, towards, {1});
    size_t seen = 0;
    for (uint32_t i = 0; i < pixels.size(); ++i) {
        const oracle::Ray ray = oracle::camera_ray(towards, i % 16 + 0.5, i / 16 + 0.5);
        const double b = dot(ray.origin, ray.direction), c = dot(ray.origin, ray.origin) - 1;
        if (b * b - c < 0.1) continue;
        const Double3 n = ray.origin + (-b - std::sqrt(b * b - c)) * ray.direction;
        const Double3 mirrored = ray.direction - (2 * dot(ray.direction, n)) * n;
        const Double3 expected = oracle::environment_at(scene, mirrored);
        ++seen;
        EXPECT_LT(max_norm(pixels[i].colour - expected), 0.01) << "pixel " << i;
    }
    EXPECT_GT(seen, 20u);
}

TEST(ReferenceFrame, CutsToWhatTheSceneSays) {
    Scene scene = body(slab(), glossy(0, 0.5f, 0, 1));
    scene.environment = {1, 1, 1};
    scene.ambient = {0.25f, 0.25f, 0.25f};
    const oracle::View towards = view({0, 0, 3}, {0, 0, 0}, 2);
    const auto first = [&](uint32_t cut, const PathLimits& limits) {
        scene.cut = cut;
        return render(scene, towards, limits)[0].colour.x;
    };
    EXPECT_EQ(first(RSH_CUT_BLACK, {0}), 0);
    EXPECT_EQ(first(RSH_CUT_AMBIENT, {0}), 0.125);
    EXPECT_EQ(first(RSH_CUT_ENVIRONMENT, {0}), 0.5);
    EXPECT_EQ(first(RSH_CUT_BLACK, {1}), 0.5);
    EXPECT_EQ(first(RSH_CUT_BLACK, {1, 0.5}), 0);
}

void add_level_square(Scene& scene, float half, float height) {
    test::Mesh mesh;
    mesh.vertices = {{-half, height, -half},
                     {half, height, -half},
                     {-half, height, half},
                     {half, height, half}};
    mesh.indices = {0, 2, 1, 1, 2, 3};
    scene.add(mesh, 0, nullptr);
}

// A floor below a small roof; the light is at a height of 2, or infinitely far up.
TEST(ReferenceFrame, HidesLightsBehindWhatIsInBetween) {
    const auto seen_under_roof = [](float height, rsh_light light) {
        Scene scene = body({}, test::matte({1, 1, 1}));
        add_level_square(scene, 9, 0);
        add_level_square(scene, 1, height);
        scene.lights = {light};
        return render(scene, view({5, 0.3f, 0}, {0, 0, 0}, 1), {0})[0].colour.x;
    };
    rsh_light lamp = test::point_light({0, 2, 0}, {0.5f, 0.5f, 0.5f});
    EXPECT_EQ(seen_under_roof(1.5f, lamp), 0);
    EXPECT_NEAR(seen_under_roof(2.5f, lamp), 0.5, 1e-9);
    EXPECT_EQ(seen_under_roof(2.5f, test::directional_light({0, -1, 0}, {1, 1, 1})), 0);
    lamp.casts_shadow = 0;
    EXPECT_NEAR(seen_under_roof(1.5f, lamp), 0.5, 1e-9);
}

TEST(ReferenceFrame, AveragesTheSamplesOfAPixel) {
    const Scene scene = test::gallery();
    const oracle::View small = {test::gallery_camera(16, 12), 16, 12};
    const oracle::View large = {small.camera, 32, 24};
    const auto mean = render(scene, small, {1, 0, 2});
    const auto all = render(scene, large, {1});
    for (uint32_t y = 0; y < 12; ++y)
        for (uint32_t x = 0; x < 16; ++x) {
            const auto at = [&](uint32_t dx, uint32_t dy) {
                return all[(2 * y + dy) * 32 + 2 * x + dx].colour;
            };
            const Double3 sum = at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1);
            EXPECT_LT(max_norm(mean[y * 16 + x].colour - 0.25 * sum), 1e-9);
        }
}

// Everything there is: textures, smooth normals, mirrors, glass, lights of all kinds and shadows. Only
// at edges, which floats may see a little beside, is rsh's picture another one.
TEST(ReferenceFrame, IsWhatRshShows) {
    const Scene scene = test::gallery();
    test::FrameOptions options;
    options.width = test::small() ? 8 : 64;
    options.height = test::small() ? 6 : 48;
    for (const uint32_t bounces : {0u, 1u, 4u}) {
        options.bounces = bounces;
        const auto shown = test::frame(test::DeviceScene(scene), options);
        const auto pixels = render(scene,
                                   {test::gallery_camera(options.width, options.height),
                                    options.width, options.height},
                                   {bounces});
        size_t different = 0;
        for (size_t i = 0; i < pixels.size(); ++i) {
            const Double3 rsh = {shown[i].s[0], shown[i].s[1], shown[i].s[2]};
            different += max_norm(pixels[i].colour - rsh) > 1e-3;
        }
        EXPECT_LE(different, pixels.size() / 500) << bounces << " bounces";
    }
}

}  // namespace
