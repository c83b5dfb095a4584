// view_keys_test.cpp - cameras and lights that move by keys of the scene file.
#include "scene/view/view_keys.hpp"

#include <gtest/gtest.h>

#include "scene/scene_file.hpp"
#include "scene/world.hpp"

namespace render {
namespace {

SceneDescription scene(const std::string& members) {
    return parse_scene(
        R"({"meshes": [{"generator": "room", "triangles": 1500}], )" + members + "}",
        "scene.json");
}

void expect_error(const std::string& members, std::initializer_list<const char*> parts) {
    std::string message;
    try {
        scene(members);
    } catch (const std::exception& error) {
        message = error.what();
    }
    for (const char* part : parts)
        EXPECT_NE(message.find(part), std::string::npos)
            << members << ": \"" << part << "\" is not in: " << message;
}

void expect_near(glm::vec3 actual, glm::vec3 expected, const char* what) {
    EXPECT_LT(glm::distance(actual, expected), 1e-5f)
        << what << ": " << actual.x << " " << actual.y << " " << actual.z << ", expected "
        << expected.x << " " << expected.y << " " << expected.z;
}

constexpr const char* kCamera =
    R"("camera": {"eye": [0, 0, 8], "at": [0, 0, 0], "near": 0.5, "keys": [
        {"time": 1, "vertical_degrees": 40},
        {"time": 3, "eye": [4, 0, 8], "at": [0, 2, 0], "vertical_degrees": 60}]})";

TEST(ViewKeys, CamerasGoEvenlyFromKeyToKey) {
    const SceneCamera camera = *scene(kCamera).camera;
    for (const double early : {-5.0, 1.0}) {
        expect_near(camera_at(camera, early).eye, {0, 0, 8}, "eye");
        EXPECT_EQ(camera_at(camera, early).vertical_degrees, 40.0f);
    }
    const Camera quarter = camera_at(camera, 1.5);
    expect_near(quarter.eye, {1, 0, 8}, "eye");
    expect_near(quarter.at, {0, 0.5f, 0}, "at");
    EXPECT_FLOAT_EQ(quarter.vertical_degrees, 45.0f);
    EXPECT_EQ(quarter.near, 0.5f);
    for (const double late : {3.0, 99.0})
        expect_near(camera_at(camera, late).eye, {4, 0, 8}, "eye");
}

TEST(ViewKeys, LightsChangeWhatTheirKeysName) {
    const auto lights = *scene(R"("lights": [
        {"kind": "point", "position": [1, 2, 3], "colour": 2, "attenuation": [0, 0, 1], "keys": [
            {"time": 0}, {"time": 2, "colour": [0, 0, 4]}, {"time": 4, "position": [5, 2, 3]}]},
        {"kind": "directional", "direction": [0, -1, 0], "keys": [
            {"time": 0}, {"time": 1, "direction": [1, 0, 0]}]},
        {"kind": "spot", "position": [0, 4, 0], "at": [0, 0, 0], "keys": [
            {"time": 0}, {"time": 1, "position": [4, 4, 0]},
            {"time": 2, "position": [4, 4, 0], "at": [4, 0, 0]}]}])")
                             .lights;
    const Light point = light_at(lights[0], 1.0);
    expect_near(point.colour, {1, 1, 3}, "colour");
    expect_near(point.position, {1, 2, 3}, "position");
    EXPECT_EQ(point.attenuation, glm::vec3(0, 0, 1));
    expect_near(light_at(lights[0], 3.0).position, {3, 2, 3}, "position");
    expect_near(light_at(lights[0], 4.0).colour, {2, 2, 2}, "colour, the light's own again");
    expect_near(light_at(lights[1], 0.5).direction, {0.5f, -0.5f, 0}, "direction");
    expect_near(light_at(lights[2], 0.5).direction, {-2, -4, 0}, "at the place that stays");
    expect_near(light_at(lights[2], 1.5).direction, {-2, -4, 0}, "at the place that moves");
    expect_near(light_at(lights[2], 2.0).direction, {0, -4, 0}, "at the place that moves");
}

TEST(ViewKeys, WorldsMoveTheirCameraAndLights) {
    World world(scene(std::string(kCamera) +
                      R"(, "lights": [{"kind": "point", "position": [0, 0, 0], "keys": [
                            {"time": 0}, {"time": 10, "position": [5, 0, 0]}]}])"));
    EXPECT_EQ(world.time_span().start, 0.0);
    EXPECT_EQ(world.time_span().end, 10.0);
    world.move_to(2.0);
    expect_near(world.camera().eye, {2, 0, 8}, "eye");
    expect_near(world.lights().at(0).position, {1, 0, 0}, "position");
    EXPECT_TRUE(world.moved().empty()) << "no vertex moves";
}

TEST(ViewKeys, TimesOutsideOfTheMotionAreAWarning) {
    const World world(scene(kCamera));
    EXPECT_TRUE(world.warnings_at(2.0).empty());
    ASSERT_EQ(world.warnings_at(0.5).size(), 1u);
    EXPECT_EQ(world.warnings_at(0.5)[0],
              "camera: moves from 1 s to 3 s; at 0.5 s it stands as at its start");
    ASSERT_EQ(world.warnings_at(4.0).size(), 1u);
}

TEST(ViewKeys, WrongKeysAreNamed) {
    const auto camera = [](const std::string& keys) {
        return R"("camera": {"eye": [0, 0, 5], "at": [0, 0, 0], "keys": )" + keys + "}";
    };
    const auto light = [](const std::string& kind, const std::string& keys) {
        return R"("lights": [{"kind": ")" + kind +
               R"(", "position": [0, 5, 0], "direction": [0, -1, 0], "keys": )" + keys + "}]";
    };
    expect_error(camera("[]"), {"camera.keys", "at least one key"});
    expect_error(camera(R"([{"eye": [1, 2, 3]}])"), {"camera.keys[0]", "\"time\"", "required"});
    expect_error(camera(R"([{"time": 1}, {"time": 1}])"), {"camera.keys[1].time", "after"});
    expect_error(camera(R"([{"time": 0, "up": [0, 1, 0]}])"), {"camera.keys[0].up", "unknown"});
    expect_error(camera(R"([{"time": 0, "vertical_degrees": 0}])"),
                 {"vertical_degrees", "0.01"});
    expect_error(camera(R"([{"time": 0, "eye": [0, 9, 0]}])"), {"camera.keys[0]", "\"up\""});
    expect_error(camera(R"([{"time": 0}, {"time": 1, "eye": [0, 0, -5]}])"),
                 {"camera.keys[1]", "along \"up\""});
    expect_error(light("point", R"([{"time": 0, "direction": [1, 0, 0]}])"),
                 {"lights[0].keys[0].direction", "has none"});
    expect_error(light("directional", R"([{"time": 0, "position": [1, 0, 0]}])"),
                 {"lights[0].keys[0].position", "has none"});
    expect_error(light("spot", R"([{"time": 0, "at": [0, 5, 0]}])"),
                 {"lights[0].keys[0]", "\"position\" other than \"at\""});
    expect_error(light("spot", R"([{"time": 0, "at": [0, 0, 0], "direction": [1, 0, 0]}])"),
                 {"lights[0].keys[0]", "either"});
    expect_error(light("spot", R"([{"time": 0}, {"time": 1, "direction": [0, 2, 0]}])"),
                 {"lights[0].keys[1]", "opposite"});
    expect_error(light("point", R"([{"time": 0, "colour": -1}])"),
                 {"keys[0].colour", "negative"});
}

}  // namespace
}  // namespace render
