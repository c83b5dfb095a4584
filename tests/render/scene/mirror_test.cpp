// mirror_test.cpp - a transform that mirrors keeps the outside of a surface outside: its winding and
// its normals agree and point away from the middle.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "model/inspect.hpp"
#include "scene/scene_file.hpp"
#include "scene/world.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

constexpr const char* kCube =
    "OFF 8 6 0\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n"
    "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

World world_of(const std::string& text) {
    return World(parse_scene(text, "scene.json"));
}

double volume(const Mesh& mesh) {
    return inspect(mesh.positions, mesh.triangles).volume;
}

// A zero normal means flat; the poles of a sphere have triangles without area.
size_t normals_against_their_triangle(const Mesh& mesh) {
    size_t count = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        const glm::dvec3 normal = glm::cross(b - a, c - a) / glm::dot(b - a, b - a);
        for (int k = 0; k < 3 && !mesh.normals.empty(); ++k)
            count += glm::dot(normal, glm::dvec3(mesh.normals[t[k]])) < -1e-5;
    }
    return count;
}

void expect_outwards(const Mesh& mesh, const std::string& what) {
    EXPECT_GT(volume(mesh), 0.0) << what;
    EXPECT_EQ(normals_against_their_triangle(mesh), 0u) << what;
}

TEST(Mirror, KeepsTheOutsideOfAMeshOutside) {
    const TemporaryFolder folder;
    const std::string file = folder.write("cube.off", kCube);
    for (const char* transform :
         {R"({"scale": [0.5, 0.5, 0.5]})", R"({"scale": [-0.5, 0.5, 0.5]})", R"({"scale": -2})",
          R"({"scale": [1, 2, -3]})", R"([{"scale": [-1, 1, 1]}, {"scale": [1, -1, 1]}])",
          R"([{"scale": [-1, 1, 1]}, {"rotate": {"axis": [1, 1, 0], "degrees": 50}}])",
          R"({"matrix": [[0, 1, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]})",
          R"([{"scale": [-1e-12, 1e-12, 1e-12]}, {"translate": [0, 0, 0]}])",
          R"([{"scale": -1e15}])"})
        for (const char* more :
             {"", R"(, "smooth": true)", R"(, "smooth": 30)",
              R"(, "stand": {"at": [1, 0, 2], "height": 3})",
              R"(, "smooth": 30, "keys": [{"time": 0}, {"time": 1, "scale": 0.5}])"}) {
            World world = world_of(R"({"meshes": [{"file": ")" + file + R"(", "transform": )" +
                                   transform + more + "}]}");
            expect_outwards(world.mesh(), std::string(transform) + more);
            world.move_to(0.7);
            expect_outwards(world.mesh(), std::string(transform) + more + " at 0.7");
            EXPECT_FALSE(world.has_turned_triangles());
        }
}

TEST(Mirror, KeepsTheInsideOfTheRoomInside) {
    const auto room = [](const char* transform) {
        return world_of(R"({"meshes": [{"generator": "room", "transform": )" +
                        std::string(transform) + "}]}")
            .mesh();
    };
    const double right = volume(room(R"({"scale": 1})"));
    EXPECT_NEAR(volume(room(R"({"scale": [1, 1, -1]})")), right, 1e-3 * std::abs(right));
}

TEST(Mirror, TransformsOfAffFilesMirrorToo) {
    const TemporaryFolder folder;
    const auto aff = [&](const std::string& text) {
        const std::string file = folder.write("a.aff", text);
        return world_of(R"({"meshes": [{"file": ")" + file + "\"}]}").mesh();
    };
    const std::string mirror = "xs -1 1 1 0 1 0 20 1 2 3 {\n", ball = "s 0 0 0 1\n";
    expect_outwards(aff(mirror + ball + "}\n"), "one mirror");
    expect_outwards(aff(mirror + mirror + ball + "}\n}\n"), "two mirrors");
    expect_outwards(aff(mirror + "}\n" + ball), "a mirror that is closed before");
}

TEST(Mirror, AnAnimationMayBeginToMirror) {
    const TemporaryFolder folder;
    const std::string file =
        folder.write("a.aff",
                     "a 0 1 2\nx t { s 0 0 0 1 }\nk t { scale 4 -1 2 1 1 0 0 0  0 1 1 1 0 0 0  "
                     "1 -1 1 1 0 0 0  2 -2 1 1 0 0 0 }\n");
    folder.write("cube.off", kCube);
    for (const char* more :
         {"", R"(, "transform": {"scale": [1, 1, -1]})", R"(, "smooth": 80)"}) {
        World world = world_of(R"({"meshes": [{"file": ")" + folder.path("cube.off") +
                               R"("}, {"file": ")" + file + "\"" + more + "}]}");
        for (const double time : {0.0, 1.0, 0.9, 0.1}) {
            world.move_to(time);
            EXPECT_EQ(world.has_turned_triangles(), time == 1.0 || time == 0.1) << time << more;
            expect_outwards(world.mesh(), std::to_string(time) + more);
        }
    }
}

}  // namespace
}  // namespace render
