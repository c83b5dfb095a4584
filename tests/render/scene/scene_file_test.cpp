// scene_file_test.cpp - the scene file format: what it accepts, and what it says when it does
// not.
#include "scene/scene_file.hpp"

#include <gtest/gtest.h>
#include <rsh/rsh.h>

#include <cmath>
#include <string>

#include "scene/world.hpp"
#include "temporary_folder.hpp"

namespace {

// The message of the exception that parsing throws; empty when it throws none.
std::string message_of(const std::string& text) {
    try {
        render::parse_scene(text, "scene.json");
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

void expect_in_message(const std::string& text, std::initializer_list<const char*> parts) {
    const std::string message = message_of(text);
    for (const char* part : parts)
        EXPECT_NE(message.find(part), std::string::npos)
            << "\"" << part << "\" is not in: " << message;
}

TEST(SceneFile, ReadsEveryKindOfObject) {
    const render::SceneDescription scene = render::parse_scene(R"({
        // comments are allowed
        "description": "all of it",
        "meshes": [{"generator": "room", "triangles": 5000, "mirror": "both", "glass": false,
                    "seed": 7, "transform": {"translate": [1, 2, 3]},
                    "material": {"diffuse": 0.5, "ior": 1.5},
                    "materials": {"mirror": {"reflection": [0.1, 0.2, 0.3]}}}],
        "camera": {"eye": [0, 0, 5], "at": [0, 0, 0], "vertical_degrees": 30, "near": 0.1},
        "lights": [{"kind": "spot", "position": [0, 3, 0], "at": [0, 0, 0], "outer_degrees": 40,
                    "shadow": false}],
        "ambient": 0.25,
        "environment": {"colour": [0, 0.5, 1]},
        "settings": {"size": [64, 48], "bounces": 3, "min_weight": 0.01, "frames": 5,
                     "cut": "environment", "time": [1, 2]}})",
                                                               "scene.json");
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].room.triangles, 5000);
    EXPECT_TRUE(scene.meshes[0].room.mirror_sphere);
    EXPECT_TRUE(scene.meshes[0].room.mirror_floor);
    EXPECT_FALSE(scene.meshes[0].room.glass);
    EXPECT_EQ(scene.meshes[0].transform[3], glm::dvec4(1, 2, 3, 1));
    EXPECT_EQ(*scene.meshes[0].material.diffuse, glm::vec3(0.5f));
    EXPECT_EQ(*scene.meshes[0].materials.at("mirror").reflection, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(scene.camera->vertical_degrees, 30.0f);
    ASSERT_EQ(scene.lights->size(), 1u);
    EXPECT_EQ(scene.lights->at(0).direction, glm::vec3(0, -3, 0));
    EXPECT_FALSE(scene.lights->at(0).casts_shadow);
    EXPECT_EQ(*scene.ambient, glm::vec3(0.25f));
    EXPECT_EQ(*scene.settings.cut, uint32_t{RSH_CUT_ENVIRONMENT});
    EXPECT_EQ(scene.environment->colour, glm::vec3(0, 0.5f, 1));
    EXPECT_EQ(*scene.settings.size, glm::uvec2(64, 48));
    EXPECT_EQ(scene.settings.time->end, 2.0);
}

TEST(SceneFile, SuggestsTheNearestKeyForAnUnknownOne) {
    expect_in_message(
        R"({"meshes": [{"generator": "room", "triangels": 5000}]})",
        {"scene.json", "meshes[0].triangels", "did you mean \"triangles\"", "seed"});
}

TEST(SceneFile, NamesPathFoundAndAllowedForAWrongType) {
    expect_in_message(R"({"meshes": [{"generator": "room", "material": {"diffuse": "red"}}]})",
                      {"scene.json: meshes[0].material.diffuse", "\"red\" (string)",
                       "an array of 3 numbers"});
}

TEST(SceneFile, NamesTheFoldersInWhichAMissingFileWasSought) {
    expect_in_message(R"({"meshes": [{"file": "no_such_mesh.off"}]})",
                      {"meshes[0].file", "no_such_mesh.off", "RSH_SCENES", "RSH_ASSETS"});
}

TEST(SceneFile, GivesTheLineOfASyntaxError) {
    expect_in_message("{\"meshes\":\n [}", {"scene.json: not JSON", "line 2"});
}

TEST(SceneFile, RefusesNumbersOutOfRange) {
    expect_in_message(R"({"meshes": [], "settings": {"size": [0, 1]}})",
                      {"settings.size[0]", "found 0", "from 1 to 16384"});
    expect_in_message(R"({"meshes": [], "settings": {"bounces": 2.5}})",
                      {"settings.bounces", "found 2.5", "whole number"});
    expect_in_message(R"({"meshes": [], "ambient": -1})", {"ambient", "found -1", "negative"});
}

TEST(SceneFile, RefusesACameraWithoutDirection) {
    expect_in_message(R"({"meshes": [], "camera": {"eye": [1, 1, 1], "at": [1, 1, 1]}})",
                      {"camera", "\"eye\" and \"at\" that differ"});
    expect_in_message(R"({"meshes": [], "camera": {"eye": [0, 5, 0], "at": [0, 0, 0]}})",
                      {"camera", "other than \"up\""});
}

TEST(SceneFile, RefusesKeyFramesOutOfOrder) {
    render::TemporaryFolder folder;
    folder.write("a.off", "OFF\n");
    const std::string scene = R"({"meshes": [{"file": ")" + folder.path("a.off") +
                              R"(", "keys": [{"time": 1}, {"time": 1}]}]})";
    expect_in_message(scene, {"meshes[0].keys[1].time", "after the key before"});
}

TEST(SceneFile, RefusesTwoThingsInOneTransformStep) {
    expect_in_message(R"({"meshes": [{"generator": "room",
                          "transform": [{"scale": 2, "translate": [0, 0, 0]}]}]})",
                      {"meshes[0].transform[0]", "one of translate, rotate, scale, matrix"});
}

TEST(SceneFile, AppliesTransformStepsInTheOrderOfTheList) {
    const auto scene = render::parse_scene(
        R"({"meshes": [{"generator": "room", "transform": [{"scale": 2},
            {"rotate": {"axis": [0, 1, 0], "degrees": 90}}, {"translate": [0, 0, 5]}]}]})",
        "scene.json");
    const glm::dvec4 p = scene.meshes[0].transform * glm::dvec4(1, 0, 0, 1);
    EXPECT_NEAR(p.x, 0.0f, 1e-5f);
    EXPECT_NEAR(p.z, 3.0f, 1e-5f);
}

// A cube that is cut at its edges has one normal per side; without, one per vertex.
TEST(SceneFile, SmoothMayNameTheAngleOfCreases) {
    const render::TemporaryFolder folder;
    folder.write("cube.off",
                 "OFF 8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                 "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
    const auto load = [&](const std::string& smooth) {
        const std::string scene = folder.write(
            "scene.json",
            "{\"meshes\": [{\"file\": \"cube.off\", \"smooth\": " + smooth + "}]}");
        return render::World(render::read_scenes({scene})).mesh();
    };
    EXPECT_EQ(load("false").normals.size(), 0u);
    EXPECT_EQ(load("true").normals.size(), 8u);
    const render::Mesh creased = load("30");
    ASSERT_EQ(creased.normals.size(), 24u);
    for (const glm::vec3& normal : creased.normals)
        EXPECT_EQ(std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z), 1.0f);
    expect_in_message(
        "{\"meshes\": [{\"file\": \"" + folder.path("cube.off") + "\", \"smooth\": \"yes\"}]}",
        {"meshes[0].smooth", "yes"});
}

// Two triangles at a right angle; the whole mesh moves by 1 along z.
TEST(SceneFile, CreasesMoveWithTheirMesh) {
    const render::TemporaryFolder folder;
    folder.write("fold.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\n");
    folder.write("fold.json",
                 "{\"frames\": 2, \"vertices\": 4, \"triangles\": 2, \"time_start\": 0, "
                 "\"time_end\": 1}");
    folder.write("fold.f32", render::bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1,  //
                                                      0, 0, 1, 1, 0, 1, 0, 1, 1, 0, 0, 2}));
    const std::string scene = folder.write(
        "scene.json", R"({"meshes": [{"file": "fold.obj", "vertex_frames": "fold.f32",
                                      "smooth": 45}]})");
    render::World world(render::read_scenes({scene}));
    const std::vector<glm::vec3> before = world.mesh().positions;
    world.move_to(1.0);
    ASSERT_EQ(before.size(), 6u);
    for (size_t i = 0; i < before.size(); ++i)
        EXPECT_EQ(world.mesh().positions[i], before[i] + glm::vec3(0, 0, 1)) << "vertex " << i;
}

}  // namespace
