// information_test.cpp - strings, names, versions, the device picker, and what
// rsh_find_features derives from a scene.
#include <gtest/gtest.h>

#include <climits>
#include <cstdlib>
#include <set>

#include "support/device_scene.hpp"

namespace {

TEST(StatusString, NamesEveryStatusAndAnyOtherValue) {
    std::set<std::string> texts;
    for (rsh_status status = RSH_INTERNAL_ERROR; status <= RSH_INVALID_VALUE; ++status) {
        const std::string text = rsh_status_string(status);
        EXPECT_EQ(text.rfind("RSH_", 0), 0u) << text;
        EXPECT_TRUE(texts.insert(text).second) << text << " twice";
    }
    EXPECT_NE(std::string(rsh_status_string(RSH_SUCCESS)).find("RSH_SUCCESS"),
              std::string::npos);
    EXPECT_NE(std::string(rsh_status_string(CL_OUT_OF_RESOURCES)).find("CL_OUT_OF_RESOURCES"),
              std::string::npos);
    for (const rsh_status status : {1, -4095, -4104, INT_MAX, INT_MIN})
        EXPECT_STRNE(rsh_status_string(status), "");
}

TEST(Version, IsThatOfTheHeader) {
    EXPECT_EQ(rsh_version(), cl_uint(RSH_VERSION));
}

template <class Name, class FromName>
void expect_round_trip(Name name, FromName from_name, cl_uint first, cl_uint last) {
    for (cl_uint value = first; value <= last; ++value) {
        cl_uint back = 99;
        ASSERT_NE(name(value), nullptr) << value;
        EXPECT_EQ(from_name(name(value), &back), RSH_SUCCESS);
        EXPECT_EQ(back, value);
    }
    cl_uint value = 99;
    EXPECT_EQ(name(12345), nullptr);
    EXPECT_EQ(from_name("no such thing", &value), RSH_INVALID_VALUE);
    EXPECT_NE(std::string(rsh_last_error()).find("no such thing"), std::string::npos);
    EXPECT_EQ(from_name(nullptr, &value), RSH_INVALID_VALUE);
    EXPECT_EQ(value, 99u);
}

// The last values of the header, by hand: all other tests go by the names that there are.
TEST(Names, OfStrategiesEnginesAndBoundsGoBothWays) {
    expect_round_trip(rsh_strategy_name, rsh_strategy_from_name, RSH_STRATEGY_CHUNK,
                      RSH_STRATEGY_BLELLOCH);
    expect_round_trip(rsh_engine_name, rsh_engine_from_name, RSH_ENGINE_PAPER_FAITHFUL,
                      RSH_ENGINE_BRUTE_FORCE);
    expect_round_trip(rsh_shape_name, rsh_shape_from_name, RSH_SHAPE_CONE, RSH_SHAPE_BOX);
}

TEST(FindDevice, FindsByPartOfANameAndSaysWhatItSawOtherwise) {
    cl_platform_id platform = nullptr;
    cl_device_id found = nullptr;
    const std::string name = test::device().device.getInfo<CL_DEVICE_NAME>();
    EXPECT_EQ(rsh_find_device(name.c_str(), &platform, &found), RSH_SUCCESS);
    EXPECT_EQ(found, test::device().device());
    EXPECT_EQ(rsh_find_device(name.substr(1).c_str(), nullptr, &found), RSH_SUCCESS);
    EXPECT_EQ(rsh_find_device("no such device", &platform, &found), RSH_NO_DEVICE);
    EXPECT_NE(std::string(rsh_last_error()).find("no such device"), std::string::npos)
        << rsh_last_error();
    EXPECT_EQ(rsh_find_device(nullptr, &platform, nullptr), RSH_INVALID_VALUE);
}

rsh_features features_of(const test::Scene& scene) {
    return test::DeviceScene(scene).desc.features;
}

TEST(FindFeatures, FindsWhatEachPartOfASceneNeeds) {
    const test::Scene plain = test::plain();
    EXPECT_EQ(features_of(plain), 0u);
    test::Scene scene = plain;
    scene.materials[0].reflection.s[1] = 0.1f;
    EXPECT_EQ(features_of(scene), RSH_FEATURE_REFLECTION);
    scene = plain;
    scene.lights[0].casts_shadow = 1;
    EXPECT_EQ(features_of(scene), RSH_FEATURE_SHADOW);
    EXPECT_EQ(test::DeviceScene(scene).desc.shadow_lights, 1u);
    scene = plain;
    scene.normals.assign(scene.mesh.vertices.size(), test::Float3(0, 1, 0));
    EXPECT_EQ(features_of(scene), RSH_FEATURE_SMOOTH_NORMAL);
    EXPECT_EQ(features_of(test::gallery()), RSH_FEATURE_ALL);
}

// A dielectric reflects as well: Fresnel's part.
TEST(FindFeatures, AddsReflectionToTransmission) {
    test::Scene scene = test::plain();
    scene.materials[0].transmission.s[2] = 0.5f;
    EXPECT_EQ(features_of(scene), RSH_FEATURE_REFRACTION | RSH_FEATURE_REFLECTION);
}

TEST(FindFeatures, NeedsATextureThatAMaterialUsesAndCoordinates) {
    test::Scene scene = test::gallery();
    scene.environment_texture = 0;
    EXPECT_EQ(features_of(scene), RSH_FEATURE_ALL & ~RSH_FEATURE_ENVIRONMENT_IMAGE);
    scene.materials[0].texture = RSH_NO_TEXTURE;
    EXPECT_EQ(features_of(scene) & RSH_FEATURE_TEXTURE, 0u);
    scene = test::gallery();
    scene.texcoords.clear();
    EXPECT_EQ(features_of(scene) & RSH_FEATURE_TEXTURE, 0u);
}

TEST(Statistics, CountOnlyWhileTheyAreOn) {
    const test::OwnContext context;
    rsh_statistics s = {};
    EXPECT_EQ(rsh_get_statistics(context.get(), &s), RSH_INVALID_VALUE) << "struct_size is 0";
    s.struct_size = sizeof s;
    RSH_CHECK(rsh_get_statistics(context.get(), &s));
    EXPECT_EQ(s.launches, 0u);
    EXPECT_EQ(s.struct_size, sizeof s);
    EXPECT_EQ(rsh_get_statistics(context.get(), nullptr), RSH_INVALID_VALUE);
    EXPECT_EQ(rsh_count_statistics(nullptr, CL_TRUE), RSH_INVALID_VALUE);
}

}  // namespace
