// furnace_test.cpp - paths that are cut see what the scene says. In a furnace, where all that does not
// absorb is as bright as the environment, nothing can be seen, however long the paths are.
#include <gtest/gtest.h>

#include "support/compare.hpp"
#include "support/render.hpp"

namespace {

using test::Scene;

test::Mesh ball(float radius) {
    test::Mesh mesh = test::sphere(16, 8);
    for (test::Float3& v : mesh.vertices) v = radius * v;
    return mesh;
}

rsh_material lossless(float reflection, float transmission, float index) {
    rsh_material material = test::matte({0, 0, 0});
    material.reflection = {{reflection, reflection, reflection, 0}};
    material.transmission = {{transmission, transmission, transmission, index}};
    return material;
}

Scene furnace(const rsh_material& outer, const rsh_material& inner) {
    Scene scene;
    scene.add(ball(1), 0, nullptr);
    scene.add(ball(0.6f), 1, nullptr);
    scene.materials = {outer, inner};
    scene.ambient = {0, 0, 0};
    scene.environment = {1, 1, 1};
    scene.cut = RSH_CUT_ENVIRONMENT;
    return scene;
}

std::vector<cl_float4> picture(const Scene& scene, uint32_t bounces, float min_weight = 0) {
    test::FrameOptions options;
    options.width = options.height = test::small() ? 4 : 16;
    options.bounces = bounces;
    options.min_weight = min_weight;
    const rsh_camera camera =
        test::look_at({0.1f, 0.4f, 2}, {0, 0, 0}, options.width, options.height);
    options.camera = &camera;
    return test::frame(test::DeviceScene(scene), options);
}

void expect_all(const std::vector<cl_float4>& picture, float value, float error) {
    for (size_t i = 0; i < picture.size(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(picture[i].s[c], value, error) << "pixel " << i << " " << picture[i];
}

uint32_t many_bounces() {
    return test::small() ? 3 : 12;
}

TEST(Furnace, HidesMirrors) {
    const rsh_material mirror = lossless(1, 0, 1);
    for (const uint32_t bounces : {0u, 1u, many_bounces()})
        expect_all(picture(furnace(mirror, mirror), bounces), 1, 1e-3f);
}

TEST(Furnace, HidesNestedGlassOfAnyIndex) {
    for (const float index : {0.4f, 1.0f, 1.5f, 2.4f, 30.0f}) {
        SCOPED_TRACE("index " + std::to_string(index));
        const Scene scene = furnace(lossless(0, 1, index), lossless(0, 1, 1.3f));
        for (const uint32_t bounces : {0u, 3u, many_bounces()})
            expect_all(picture(scene, bounces), 1, 1e-3f);
    }
}

TEST(Furnace, HidesWhatBecomesOfLightRays) {
    const Scene scene = furnace(lossless(0, 1, 1.5f), lossless(0, 1, 1.3f));
    for (const float min_weight : {0.01f, 0.3f, 2.0f})
        expect_all(picture(scene, many_bounces(), min_weight), 1, 1e-3f);
}

TEST(Furnace, DoesNotHideWhatIsCutToBlack) {
    Scene scene = furnace(lossless(1, 0, 1), lossless(1, 0, 1));
    scene.cut = RSH_CUT_BLACK;
    float least = 1;
    for (const cl_float4& pixel : picture(scene, 0)) least = std::min(least, pixel.s[0]);
    EXPECT_EQ(least, 0);
}

TEST(Cut, AddsTheAmbientLightOrTheEnvironmentThatLiesThatWay) {
    Scene scene = furnace(lossless(0.5f, 0, 1), lossless(0.5f, 0, 1));
    scene.ambient = {0.2f, 0.4f, 0.6f};
    scene.cut = RSH_CUT_AMBIENT;
    size_t seen = 0;
    for (const cl_float4& pixel : picture(scene, 0))
        if (pixel.s[3] == 1) {
            ++seen;
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel.s[c], 0.1f * float(c + 1), 1e-6f);
        }
    EXPECT_GT(seen, 0u);
}

// A mirror before the sky of the gallery: what it sees is the same, traced or cut.
TEST(Cut, SeesTheEnvironmentsImageAsATracedRayDoes) {
    Scene scene = test::gallery();
    scene.mesh = test::Mesh();
    scene.material_ids.clear();
    scene.normals.clear();
    scene.texcoords.clear();
    scene.materials = {lossless(0.75f, 0, 1)};
    scene.mesh = ball(1);
    ASSERT_NE(scene.environment_texture, 0u);
    scene.lights.clear();
    scene.ambient = {0, 0, 0};
    scene.cut = RSH_CUT_ENVIRONMENT;
    EXPECT_TRUE(test::same_bits(picture(scene, 0), picture(scene, 1), "pixels"));
}

}  // namespace
