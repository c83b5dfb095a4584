// room_test.cpp - the generated room: its triangle count, its determinism, its solidity.
#include "generate/room.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using render::Model;
using render::RoomOptions;

Model room(int64_t triangles, bool sphere, bool floor, bool glass) {
    RoomOptions options;
    options.triangles = triangles;
    options.mirror_sphere = sphere;
    options.mirror_floor = floor;
    options.glass = glass;
    return render::make_room(options);
}

TEST(Room, MeetsTheWantedCountWithinOnePercent) {
    for (const int64_t wanted : {1500, 1501, 2999, 4000, 7919, 20000, 80000, 250000})
        for (int kinds = 0; kinds < 8; ++kinds) {
            const Model model = room(wanted, kinds & 1, kinds & 2, kinds & 4);
            const auto count = static_cast<double>(model.mesh.triangles.size());
            EXPECT_NEAR(count, wanted, 0.01 * wanted) << "options " << kinds;
        }
}

TEST(Room, RefusesACountThatItsSurfacesCannotGoDownTo) {
    EXPECT_THROW(room(100, true, true, true), std::runtime_error);
}

TEST(Room, IsTheSameEveryTime) {
    const Model a = room(20000, true, true, true), b = room(20000, true, true, true);
    EXPECT_EQ(a.mesh.positions, b.mesh.positions);
    EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
}

TEST(Room, ChangesWithItsSeed) {
    RoomOptions options;
    const Model a = render::make_room(options);
    options.seed = 2;
    EXPECT_NE(a.mesh.positions, render::make_room(options).mesh.positions);
}

TEST(Room, HasNoTriangleWithoutAreaAndEveryNormalIsUnit) {
    const Model model = room(80000, true, true, true);
    for (size_t i = 0; i < model.mesh.triangles.size(); ++i) {
        const glm::uvec3 t = model.mesh.triangles[i];
        const glm::vec3 a = model.mesh.positions[t.x];
        const glm::vec3 n =
            glm::cross(model.mesh.positions[t.y] - a, model.mesh.positions[t.z] - a);
        ASSERT_GT(glm::length(n), 0.0f) << "triangle " << i;
    }
    ASSERT_FALSE(model.mesh.normals.empty());
    for (const glm::vec3& normal : model.mesh.normals)
        ASSERT_NEAR(glm::length(normal), 1.0f, 1e-4f);
}

TEST(Room, OnlyItsMirrorsReflect) {
    const Model none = room(5000, false, false, false);
    ASSERT_FALSE(none.materials.empty());
    for (const render::Material& m : none.materials)
        EXPECT_TRUE(m.reflection == glm::vec3(0) || m.name == "mirror") << m.name;
    ASSERT_FALSE(none.mesh.material_ids.empty());
    for (const uint32_t id : none.mesh.material_ids)
        ASSERT_NE(none.materials[id].name, "mirror");
}

// Volume by the divergence theorem; a closed surface wound outwards encloses a positive one.
TEST(Room, GlassBallIsClosedAndWoundOutwards) {
    const Model model = room(80000, true, false, true);
    double volume = 0.0;
    for (size_t i = 0; i < model.mesh.triangles.size(); ++i) {
        if (model.materials[model.mesh.material_ids[i]].name != "glass") continue;
        const glm::uvec3 t = model.mesh.triangles[i];
        const glm::dvec3 a(model.mesh.positions[t.x]), b(model.mesh.positions[t.y]),
            c(model.mesh.positions[t.z]);
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    EXPECT_NEAR(volume, 4.0 / 3.0 * M_PI * std::pow(0.34, 3), 0.01);
}

}  // namespace
