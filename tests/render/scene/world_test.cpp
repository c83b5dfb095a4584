// world_test.cpp - what a scene says when it cannot be loaded.
#include "scene/world.hpp"

#include <gtest/gtest.h>

#include "model/warnings.hpp"
#include "scene/scene_file.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

void expect_error(const std::string& scene, std::initializer_list<const char*> parts) {
    std::string message;
    try {
        World world(parse_scene(scene, "scene.json"));
    } catch (const std::exception& error) {
        message = error.what();
    }
    for (const char* part : parts)
        EXPECT_NE(message.find(part), std::string::npos)
            << '"' << part << "\" is not in: " << message;
}

std::string mesh(const std::string& file) {
    return R"({"file": ")" + file + "\"}";
}

TEST(World, WarningsExplainWhyThereIsNoTriangle) {
    const TemporaryFolder folder;
    const std::string points = folder.write("points.off", "OFF 3 0 0\n0 0 0 1 0 0 0 1 0\n");
    const std::string wild =
        folder.write("wild.off", "OFF 3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 7\n");
    expect_error("{\"meshes\": [" + mesh(points) + "]}",
                 {"no triangle", "\nwarning: scene.json: meshes[0]", "points.off", "no face"});
    expect_error("{\"meshes\": [" + mesh(points) + ", " + mesh(wild) + "]}",
                 {"no triangle", "points.off", "wild.off", "meshes[1]"});
}

TEST(World, WarningsOfOneMeshSurviveTheNext) {
    const TemporaryFolder folder;
    const std::string points = folder.write("points.off", "OFF 3 0 0\n0 0 0 1 0 0 0 1 0\n");
    const std::string broken = folder.write("broken.off", "OFF 3 1 0\n0 0\n");
    expect_error(
        "{\"meshes\": [" + mesh(points) + ", " + mesh(broken) + "]}",
        {"meshes[1]: ", "broken.off", "\nwarning: scene.json: meshes[0]: ", "points.off"});
    const std::string textured =
        R"({"file": ")" + points + R"(", "material": {"texture": ")" + broken + "\"}}";
    expect_error("{\"meshes\": [" + textured + "]}",
                 {"texture: ", "broken.off", "\nwarning: ", "points.off"});
}

TEST(World, WarningsOfAnAffFileSurviveItsError) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "a.aff",
        "k t { transl 5 0 1 1 1 0 0 0  9 1 1 1 0 0 0  5 1 1 1 0 0 0  9 1 1 1 0 0 0  "
        "11 1 1 1 0 0 0 }\nq\n");
    expect_error("{\"meshes\": [" + mesh(file) + "]}",
                 {"line 2: unknown command 'q'", "\nwarning: ", "line 1: transl of 't'"});
}

TEST(World, VeryManyWarningsAreCounted) {
    const std::string text = with_warnings("it failed", std::vector<std::string>(1000, "so"));
    EXPECT_EQ(text.find("it failed\nwarning: so\n"), 0u);
    EXPECT_NE(text.find("and 980 warnings more"), std::string::npos);
    EXPECT_EQ(with_warnings("it failed", {}), "it failed");
}

}  // namespace
}  // namespace render
