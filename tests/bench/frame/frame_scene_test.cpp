// frame_scene_test.cpp - the generated scenes: as large as they say, the same every time,
// closed, and moving everywhere without coming apart.
#include "frame/frame_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <random>
#include <tuple>

#include "scene/world.hpp"

namespace bench {
namespace {

constexpr Reflector kRooms[] = {Reflector::kSphere, Reflector::kFloor, Reflector::kFloor45,
                                Reflector::kSeveral, Reflector::kGlass};

FrameScene room(Reflector reflector, int64_t triangles) {
    return FrameScene({"room", reflector, triangles, "", false});
}

TEST(FrameScene, HasTheTrianglesThatItsNameSays) {
    for (const Reflector reflector : kRooms)
        for (const int64_t wanted : {10000, 20000, 80000}) {
            const auto count = double(room(reflector, wanted).mesh().triangles.size());
            EXPECT_NEAR(count, wanted, 0.1 * wanted) << "reflector " << int(reflector);
        }
}

TEST(FrameScene, IsTheSameEveryTime) {
    const FrameScene a = room(Reflector::kSeveral, 10000), b = room(Reflector::kSeveral, 10000);
    EXPECT_EQ(a.mesh().triangles, b.mesh().triangles);
    std::vector<glm::vec3> p = a.mesh().positions, q = p;
    a.move(1.7, p);
    b.move(1.7, q);
    EXPECT_EQ(p, q);
}

// Moeller and Trumbore 1997 in double precision; edges count.
bool hits(glm::dvec3 origin, glm::dvec3 way, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    const glm::dvec3 u = b - a, v = c - a, p = glm::cross(way, v);
    const double determinant = glm::dot(u, p);
    if (std::abs(determinant) < 1e-14) return false;
    const glm::dvec3 s = origin - a, q = glm::cross(s, u);
    const double x = glm::dot(s, p) / determinant, y = glm::dot(way, q) / determinant;
    const bool is_ahead = (glm::dot(v, q) > 0) == (determinant > 0);
    return is_ahead && x >= -1e-9 && y >= -1e-9 && x + y <= 1 + 1e-9;
}

bool hits_anything(const FrameScene& scene, const std::vector<glm::vec3>& positions,
                   glm::dvec3 way) {
    const auto& triangles = scene.mesh().triangles;
    return std::any_of(triangles.begin(), triangles.end(), [&](const glm::uvec3& t) {
        return hits(scene.camera().eye, way, positions[t.x], positions[t.y], positions[t.z]);
    });
}

TEST(FrameScene, IsClosedAroundItsCameraAtRestAndMoved) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (const Reflector reflector : kRooms) {
        const FrameScene scene = room(reflector, 10000);
        std::vector<glm::vec3> moved = scene.mesh().positions;
        scene.move(1.5, moved);
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 way(normal(random), normal(random), normal(random));
            ASSERT_TRUE(hits_anything(scene, scene.mesh().positions, way))
                << "reflector " << int(reflector) << ", direction " << i;
            ASSERT_TRUE(hits_anything(scene, moved, way))
                << "reflector " << int(reflector) << ", moved, direction " << i;
        }
    }
}

TEST(FrameScene, MovesEveryVertexALittle) {
    const FrameScene scene = room(Reflector::kFloor, 20000);
    std::vector<glm::vec3> moved = scene.mesh().positions;
    scene.move(1.5, moved);
    for (size_t i = 0; i < moved.size(); ++i) {
        const float distance = glm::distance(moved[i], scene.mesh().positions[i]);
        ASSERT_GT(distance, 0.0f) << "vertex " << i;
        ASSERT_LT(distance, 0.1f) << "vertex " << i;
    }
}

TEST(FrameScene, KeepsVerticesTogetherThatShareAPlace) {
    const FrameScene scene = room(Reflector::kSphere, 10000);
    std::vector<glm::vec3> moved = scene.mesh().positions;
    scene.move(1.5, moved);
    std::map<std::tuple<float, float, float>, glm::vec3> places;
    size_t shared = 0;
    for (size_t i = 0; i < moved.size(); ++i) {
        const glm::vec3 p = scene.mesh().positions[i];
        const auto [place, is_new] = places.insert({{p.x, p.y, p.z}, moved[i]});
        ASSERT_EQ(place->second, moved[i]) << "vertex " << i;
        shared += !is_new;
    }
    EXPECT_GT(shared, 100u);
}

TEST(FrameScene, TurnsTheFloorBy45DegreesWithCameraAndLights) {
    const FrameScene flat = room(Reflector::kFloor, 10000),
                     turned = room(Reflector::kFloor45, 10000);
    EXPECT_NEAR(glm::distance(flat.camera().eye, flat.lights()[0].position),
                glm::distance(turned.camera().eye, turned.lights()[0].position), 1e-4);
    const glm::uvec3 t = turned.mesh().triangles.front();  // of the floor
    const auto& p = turned.mesh().positions;
    const glm::vec3 n = glm::normalize(glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]));
    EXPECT_NEAR(n.y, std::sqrt(0.5f), 1e-4);
}

// The room takes a way of its own to the device's structs, without what reads scene files.
TEST(FrameScene, HasTheBitsOfTheSameRoomInASceneFile) {
    render::SceneDescription description;
    render::MeshEntry& entry = description.meshes.emplace_back();
    entry.room.triangles = 10000;
    entry.room.mirror_sphere = entry.room.glass = false;
    entry.room.mirror_floor = true;
    entry.transform =
        glm::rotate(glm::mat4(1.0f), glm::radians(45.0f), glm::vec3(0.6f, 0.0f, 0.8f));
    const render::World world(description);
    const FrameScene scene = room(Reflector::kFloor45, 10000);
    EXPECT_EQ(scene.mesh().positions, world.mesh().positions);
    EXPECT_EQ(scene.mesh().normals, world.mesh().normals);
    EXPECT_EQ(scene.mesh().triangles, world.mesh().triangles);
    EXPECT_EQ(scene.mesh().material_ids, world.mesh().material_ids);
    EXPECT_EQ(scene.camera().eye, world.camera().eye);
    EXPECT_EQ(scene.camera().up, world.camera().up);
    EXPECT_EQ(scene.lights()[1].position, world.lights()[1].position);
    ASSERT_EQ(scene.materials().size(), world.materials().size());
    EXPECT_EQ(std::memcmp(scene.materials().data(), world.materials().data(),
                          scene.materials().size() * sizeof(rsh_material)),
              0);
}

TEST(FrameScene, HasAPointLight) {
    for (const Reflector reflector : kRooms) EXPECT_EQ(room(reflector, 10000).point_light(), 0);
}

}  // namespace
}  // namespace bench
