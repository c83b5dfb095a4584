// gltf_animation_test.cpp - nodes, joints and morph targets in motion: values that can be worked out by hand.
// tests/scenes/gltf_check.py compares real models with an evaluation of its own.
#include <gtest/gtest.h>

#include <cmath>

#include "import/gltf/gltf_animation.hpp"
#include "import/gltf/gltf_builder.hpp"
#include "import/gltf/gltf_curve.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

constexpr float kHalf = 0.70710678f;  // sine and cosine of 45 degrees

std::unique_ptr<Animation> load(const GltfBuilder& file, const std::string& clip = "") {
    const TemporaryFolder folder;
    return load_gltf(folder.write("a.gltf", file.text()), clip);
}

void expect_near(glm::vec3 actual, glm::vec3 expected, const std::string& what) {
    EXPECT_LT(glm::distance(actual, expected), 1e-5f)
        << what << ": " << actual.x << " " << actual.y << " " << actual.z << ", expected "
        << expected.x << " " << expected.y << " " << expected.z;
}

// A triangle with the corner (1, 0, 0), about z: 90 degrees in 2 seconds from time 1 on.
GltfBuilder turning(const char* interpolation = "LINEAR") {
    GltfBuilder file;
    file.add_triangle();
    file.animate(0, "rotation", interpolation, {1, 3},
                 file.floats("VEC4", {0, 0, 0, 1, 0, 0, kHalf, kHalf}));
    return file;
}

TEST(GltfAnimation, NodesTurnEvenlyAndStandStillOutsideOfTheClip) {
    const auto animation = load(turning());
    EXPECT_TRUE(animation->moves());
    EXPECT_EQ(animation->start(), 1.0);
    EXPECT_EQ(animation->end(), 3.0);
    EXPECT_EQ(animation->frames(), 2);
    struct Case {
        double time, degrees;
    };
    for (const Case c :
         {Case{-5, 0}, Case{1, 0}, Case{1.5, 22.5}, Case{2, 45}, Case{3, 90}, Case{9, 90}}) {
        const double angle = glm::radians(c.degrees);
        expect_near(animation->at(c.time).mesh.positions[1],
                    {std::cos(angle), std::sin(angle), 0}, "time " + std::to_string(c.time));
    }
}

TEST(GltfAnimation, StepsKeepTheKeyBefore) {
    const auto animation = load(turning("STEP"));
    expect_near(animation->at(2.9).mesh.positions[1], {1, 0, 0}, "before the second key");
    expect_near(animation->at(3.0).mesh.positions[1], {0, 1, 0}, "at the second key");
}

// From 0 to 1 in 2 s with tangents of 1 at both ends: at u = 1/2, 1/2 + 2 (1/8 - 1/8) = 1/2; at
// u = 1/4, 5/32 + 2 (9/64 - 3/64) = 11/32.
TEST(GltfAnimation, CubicSplinesGoThroughTheirKeysWithTheirTangents) {
    GltfBuilder file;
    file.add_triangle();
    file.animate(0, "translation", "CUBICSPLINE", {0, 2},
                 file.floats("VEC3", {9, 9, 9, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 9, 9, 9}));
    const auto animation = load(file);
    for (const auto& [time, x] : {std::pair(0.0, 0.0f), std::pair(0.5, 11.0f / 32.0f),
                                  std::pair(1.0, 0.5f), std::pair(2.0, 1.0f)})
        expect_near(animation->at(time).mesh.positions[0], {x, 0, 0},
                    "time " + std::to_string(time));
}

// A quaternion and its opposite are one rotation.
TEST(GltfAnimation, RotationsTakeTheShorterWay) {
    GltfBuilder file;
    file.add_triangle();
    file.animate(0, "rotation", "LINEAR", {0, 1},
                 file.floats("VEC4", {0, 0, 0, 1, 0, 0, -kHalf, -kHalf}));
    expect_near(load(file)->at(0.5).mesh.positions[1], {kHalf, kHalf, 0}, "half way");
}

TEST(GltfAnimation, ChildrenGoAlong) {
    GltfBuilder file = turning();
    file.add_triangle();
    file.json["nodes"][0]["children"] = {1};
    file.json["nodes"][1]["translation"] = {2, 0, 0};
    expect_near(load(file)->at(3.0).mesh.positions[3], {0, 2, 0}, "the child's origin");
}

TEST(GltfAnimation, WhatStandsStillIsNotTurned) {
    GltfBuilder file = turning();
    file.add_triangle();
    const auto animation = load(file);
    const Mesh first = animation->at(1.0).mesh, last = animation->at(3.0).mesh;
    for (size_t i = 3; i < 6; ++i) EXPECT_EQ(first.positions[i], last.positions[i]);
}

TEST(GltfAnimation, ANodeThatBeginsToMirrorTurnsItsTriangles) {
    GltfBuilder file;
    file.add_triangle();
    file.animate(0, "scale", "LINEAR", {0, 1}, file.floats("VEC3", {1, 1, 1, -1, 1, 1}));
    const auto animation = load(file);
    EXPECT_EQ(animation->at(0.4).mesh.triangles[0], glm::uvec3(0, 1, 2));
    EXPECT_EQ(animation->at(0.6).mesh.triangles[0], glm::uvec3(0, 2, 1));
}

// A strip along x, bound to a bone at 0 and one at 1, which bends by 90 degrees about z in a second.
GltfBuilder two_bones() {
    GltfBuilder file;
    const int positions =
        file.floats("VEC3", {0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 2, 0, 0, 2, 0, 1});
    const int normals =
        file.floats("VEC3", {0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0});
    const int joints = file.bytes("VEC4", {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0,  //
                                           0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    const int weights = file.floats("VEC4", {1,    0,    0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0,
                                             0.5f, 0.5f, 0, 0, 1, 0, 0, 0, 1,    0,    0, 0});
    file.add_mesh({{"attributes",
                    {{"POSITION", positions},
                     {"NORMAL", normals},
                     {"JOINTS_0", joints},
                     {"WEIGHTS_0", weights}}},
                   {"mode", 5}});
    file.json["nodes"][0]["skin"] = 0;
    file.json["nodes"][0]["translation"] = {50, 50, 50};  // joints place it, not its node
    file.json["nodes"].push_back({{"children", {2}}});
    file.json["nodes"].push_back({{"translation", {1, 0, 0}}});
    const int binds = file.floats("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,
                                           1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1});
    file.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", binds}}};
    file.animate(2, "rotation", "LINEAR", {0, 1},
                 file.floats("VEC4", {0, 0, 0, 1, 0, 0, kHalf, kHalf}));
    return file;
}

TEST(GltfAnimation, JointsBendAStrip) {
    const auto animation = load(two_bones());
    const Mesh rest = animation->at(0.0).mesh, bent = animation->at(1.0).mesh,
               half = animation->at(0.5).mesh;
    for (size_t i = 0; i < 6; ++i) {
        const float x = float(i / 2), z = float(i % 2);
        expect_near(rest.positions[i], {x, 0, z}, "rest, vertex " + std::to_string(i));
    }
    expect_near(bent.positions[2], {1, 0, 0}, "the knee");
    expect_near(bent.positions[4], {1, 1, 0}, "the end, bent");
    expect_near(bent.positions[5], {1, 1, 1}, "the end, bent");
    expect_near(half.positions[4], {1 + kHalf, kHalf, 0}, "the end, half way");
    expect_near(bent.normals[0], {0, 1, 0}, "a normal of the first bone");
    expect_near(bent.normals[4], {-1, 0, 0}, "a normal of the second bone");
    expect_near(bent.normals[2], {-kHalf, kHalf, 0}, "a normal of both");
}

TEST(GltfAnimation, EightJointsShareAVertexAndWeightsAddUpToOne) {
    GltfBuilder file;
    nlohmann::json attributes{{"POSITION", file.floats("VEC3", {0, 0, 0, 0, 0, 0, 0, 0, 0})}};
    for (int set = 0; set < 2; ++set) {
        std::vector<uint8_t> joints;
        for (int i = 0; i < 12; ++i) joints.push_back(uint8_t(4 * set + i % 4));
        attributes["JOINTS_" + std::to_string(set)] = file.bytes("VEC4", joints);
        attributes["WEIGHTS_" + std::to_string(set)] =
            file.floats("VEC4", {0.25f, 0.25f, 0.25f, 0.25f, 0, 0, 0, 0.5f, 0, 0, 0, 0});
    }
    file.add_mesh({{"attributes", attributes}});
    file.json["nodes"][0]["skin"] = 0;
    nlohmann::json joints = nlohmann::json::array();
    for (int i = 0; i < 8; ++i) {
        file.json["nodes"].push_back({{"translation", {i + 1, 0, 0}}});
        joints.push_back(i + 1);
    }
    file.json["skins"] = {{{"joints", joints}}};
    const Model model = load(file)->at(0.0);
    expect_near(model.mesh.positions[0], {4.5f, 0, 0}, "all eight, of sum 2");
    expect_near(model.mesh.positions[1], {6, 0, 0}, "the fourth and the eighth");
    expect_near(model.mesh.positions[2], {1, 0, 0}, "none: the first");
    ASSERT_EQ(model.warnings.size(), 1u);
    EXPECT_NE(model.warnings[0].find("1 vertices have no weight"), std::string::npos);
}

// A quad with two targets: one lifts a corner and tilts its normal, one moves all to the right.
GltfBuilder morphing() {
    GltfBuilder file;
    const int positions = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    const int normals = file.floats("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int lift = file.sparse("VEC3", 4, {3}, {0, 0, 2});
    const int tilt = file.sparse("VEC3", 4, {3}, {1, 0, 0});
    const int right = file.floats("VEC3", {4, 0, 0, 4, 0, 0, 4, 0, 0, 4, 0, 0});
    file.add_mesh(
        {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
         {"mode", 5},
         {"targets", {{{"POSITION", lift}, {"NORMAL", tilt}}, {{"POSITION", right}}}}});
    return file;
}

TEST(GltfAnimation, MorphTargetsMoveCornersAndNormals) {
    GltfBuilder file = morphing();
    file.animate(0, "weights", "LINEAR", {0, 2}, file.floats("SCALAR", {0, 0, 1, 0.5f}));
    const auto animation = load(file);
    const Mesh half = animation->at(1.0).mesh, whole = animation->at(2.0).mesh;
    expect_near(half.positions[3], {2, 1, 1}, "the corner, half way");
    expect_near(half.positions[0], {1, 0, 0}, "another one, half way");
    expect_near(whole.positions[3], {3, 1, 2}, "the corner");
    expect_near(whole.normals[3], {kHalf, 0, kHalf}, "its normal");
    expect_near(whole.normals[0], {0, 0, 1}, "another one");
}

TEST(GltfAnimation, WeightsAreTheNodesElseTheMeshesElseNone) {
    GltfBuilder file = morphing();
    expect_near(load(file)->at(0.0).mesh.positions[3], {1, 1, 0}, "none");
    file.json["meshes"][0]["weights"] = {0.5, 0};
    expect_near(load(file)->at(0.0).mesh.positions[3], {1, 1, 1}, "the mesh's");
    file.json["nodes"][0]["weights"] = {0, 1};
    expect_near(load(file)->at(0.0).mesh.positions[3], {5, 1, 0}, "the node's");
}

TEST(GltfAnimation, LightsAndCamerasGoWithTheirNodes) {
    GltfBuilder file = turning();
    file.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    nlohmann::json child{{"camera", 0}, {"translation", {1, 0, 0}}};
    child["extensions"]["KHR_lights_punctual"]["light"] = 0;
    file.json["nodes"].push_back(child);
    file.json["nodes"][0]["children"] = {1};
    const Model model = load(file)->at(3.0);
    expect_near(model.lights.at(0).position, {0, 1, 0}, "light");
    expect_near(model.camera->eye, {0, 1, 0}, "eye");
    expect_near(model.camera->up, {-1, 0, 0}, "up");
}

TEST(GltfAnimation, ClipsGoByNameOrNumber) {
    GltfBuilder file = turning();
    nlohmann::json other = file.json["animations"][0];
    other["name"] = "still";
    other["samplers"][0]["interpolation"] = "STEP";
    file.json["animations"].push_back(other);
    const glm::vec3 turned = {kHalf, kHalf, 0}, still = {1, 0, 0};
    expect_near(load(file)->at(2.0).mesh.positions[1], turned, "the first");
    expect_near(load(file, "0")->at(2.0).mesh.positions[1], turned, "number 0");
    expect_near(load(file, "1")->at(2.0).mesh.positions[1], still, "number 1");
    expect_near(load(file, "still")->at(2.0).mesh.positions[1], still, "by name");
    const auto warnings = load(file)->at(0.0).warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("2 clips, of which \"0\" plays"), std::string::npos);
    EXPECT_TRUE(load(file, "still")->at(0.0).warnings.empty());
    try {
        load(file, "stil");
        ADD_FAILURE() << "found a clip that is not there";
    } catch (const std::exception& error) {
        EXPECT_NE(std::string(error.what()).find("\"stil\""), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("nearest: \"still\""), std::string::npos);
    }
}

TEST(GltfCurve, NormalizedRotationsAreUnits) {
    GltfCurve curve;
    curve.path = GltfPath::rotation;
    curve.width = 4;
    curve.times = {0, 1};
    curve.values = {0, 0, 0, 0.9f, 0, 0, 0, 0};  // rounded, and none at all
    for (const double time : {0.0, 0.5, 1.0})
        EXPECT_EQ(value_at(curve, time), (std::vector<double>{0, 0, 0, 1})) << time;
}

}  // namespace
}  // namespace render
