// subsets_test.cpp - what a scene does not have does not show, whether programs were compiled without it or
// with it: every set of features, rendered with its own mask and with all bits.
#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "support/render.hpp"

namespace {

constexpr rsh_features kFeatures[] = {RSH_FEATURE_REFRACTION, RSH_FEATURE_TEXTURE,
                                      RSH_FEATURE_SMOOTH_NORMAL, RSH_FEATURE_ENVIRONMENT_IMAGE};
constexpr uint32_t kSets = 16;

rsh_features set_of(uint32_t number) {
    rsh_features set = 0;
    for (uint32_t k = 0; k < 4; ++k)
        if (number >> k & 1) set |= kFeatures[k];
    return set;
}

// The gallery, with mirrors and shadows, but without other features. It has all buffers, which say so: no
// material names a texture, normals are 0, and the image of the environment is one white texel.
test::Scene gallery_with(rsh_features features) {
    test::Scene scene = test::gallery();
    if (!(features & RSH_FEATURE_REFRACTION))
        for (rsh_material& material : scene.materials)
            for (int k = 0; k < 3; ++k) material.transmission.s[k] = 0;
    if (!(features & RSH_FEATURE_TEXTURE))
        for (rsh_material& material : scene.materials) material.texture = RSH_NO_TEXTURE;
    if (!(features & RSH_FEATURE_SMOOTH_NORMAL))
        scene.normals.assign(scene.normals.size(), test::Float3());
    if (!(features & RSH_FEATURE_ENVIRONMENT_IMAGE)) {
        const std::vector<float> white = {1, 1, 1, 1};
        scene.environment_texture = 1 + scene.add_texture(1, 1, white);
    }
    return scene;
}

std::vector<uint8_t> picture(const test::Scene& scene, rsh_features features) {
    test::DeviceScene on_device(scene);
    on_device.desc.features = features;
    test::FrameOptions options;
    options.bounces = 2;
    const std::vector<cl_float4> pixels = test::frame(on_device, options);
    std::vector<uint8_t> bytes(pixels.size() * sizeof(cl_float4));
    std::memcpy(bytes.data(), pixels.data(), bytes.size());
    return bytes;
}

TEST(SubsetsOfFeatures, ShowTheSameLeftOutAndCompiledIn) {
    const rsh_features always = RSH_FEATURE_REFLECTION | RSH_FEATURE_SHADOW;
    std::set<std::vector<uint8_t>> different;
    for (uint32_t number = 0; number < kSets; ++number) {
        const test::Scene scene = gallery_with(set_of(number));
        const auto left_out = picture(scene, always | set_of(number));
        EXPECT_TRUE(left_out == picture(scene, RSH_FEATURE_ALL)) << "of the set " << number;
        different.insert(left_out);
    }
    EXPECT_EQ(different.size(), kSets) << "each feature must show, or this test shows nothing";
}

// Neither do rays that no material and no lamp asks for.
TEST(SubsetsOfFeatures, WithoutReflectionAndShadowShowTheSame) {
    test::Scene scene = gallery_with(0);
    for (rsh_material& material : scene.materials)
        for (int k = 0; k < 3; ++k) material.reflection.s[k] = 0;
    const auto left_out = picture(scene, RSH_FEATURE_SHADOW);
    EXPECT_TRUE(left_out == picture(scene, RSH_FEATURE_ALL));
    for (rsh_light& light : scene.lights) light.casts_shadow = 0;
    EXPECT_TRUE(picture(scene, 0) == picture(scene, RSH_FEATURE_ALL));
}

}  // namespace
