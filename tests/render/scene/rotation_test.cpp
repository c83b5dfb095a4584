// rotation_test.cpp - the turns between two keys are those that were asked for.
#include "scene/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/scene_file.hpp"
#include "scene/world.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

const glm::dvec3 kX(1, 0, 0), kY(0, 1, 0);

Rotation about(glm::dvec3 axis, double degrees) {
    return {axis, degrees};
}

void expect_same(const glm::dquat& found, const glm::dquat& right, const char* what) {
    EXPECT_NEAR(std::abs(glm::dot(found, right)), 1.0, 1e-12)
        << what << ": " << found.w << ' ' << found.x << ' ' << found.y << ' ' << found.z
        << " instead of " << right.w << ' ' << right.x << ' ' << right.y << ' ' << right.z;
}

TEST(Rotation, DegreesAboutOneAxisGoLinearly) {
    for (const double from : {0.0, 45.0, 350.0, -360.0})
        for (const double to : {90.0, 180.0, 270.0, 360.0, 720.0, -90.0, -270.0, 3600.0, 10.0})
            for (const double u : {0.0, 0.25, 0.6, 1.0}) {
                const double degrees = from + u * (to - from);
                expect_same(rotation_between(about(kY, from), about(kY, to), u),
                            quaternion(about(kY, degrees)), "the same axis");
                expect_same(rotation_between(about(kY, from), about(-kY, -to), u),
                            quaternion(about(kY, degrees)), "the opposite axis");
            }
}

TEST(Rotation, NoDegreesAreSoAboutAnyAxis) {
    for (const double u : {0.2, 0.5, 1.0}) {
        expect_same(rotation_between(about(kX, 0), about(kY, 270), u),
                    quaternion(about(kY, 270 * u)), "from 0");
        expect_same(rotation_between(about(kX, 270), about(kY, 0), u),
                    quaternion(about(kX, 270 * (1 - u))), "to 0");
        expect_same(rotation_between(about(kX, 720), about(kY, 360), u),
                    quaternion(about(kY, 360 * u)), "after whole turns");
        expect_same(rotation_between(rotation_of({-2, 0, 0, 0}), about(kY, 360), u),
                    quaternion(about(kY, 360 * u)), "from the quaternion of none");
    }
}

TEST(Rotation, BetweenAxesItGoesTheShorterWayAndThenTurns) {
    const glm::dquat a = quaternion(about(kX, 90)), b = quaternion(about(kY, 90));
    for (const double u : {0.0, 0.3, 1.0}) {
        expect_same(rotation_between(about(kX, 90), about(kY, 90), u), glm::slerp(a, b, u),
                    "the shorter way");
        expect_same(rotation_between(about(kX, 90), about(kY, 450), u),
                    quaternion(about(kY, 360 * u)) * glm::slerp(a, b, u), "with a turn on top");
        expect_same(rotation_between(rotation_of(a), rotation_of(b), u), glm::slerp(a, b, u),
                    "quaternions");
    }
}

TEST(Rotation, AQuaternionIsAtMostHalfATurn) {
    for (const double degrees : {0.0, 90.0, 180.0, 200.0, 350.0}) {
        const Rotation r = rotation_of(3.0 * quaternion(about(kX, degrees)));
        expect_same(quaternion(r), quaternion(about(kX, degrees)), "back again");
        EXPECT_LE(r.degrees, 180.0 + 1e-9);
    }
}

// Where the corner at (1, 0, 0) of a mesh is at a time.
glm::vec3 corner_at(const std::string& more, double time) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "a.obj", "v 1 0 0\nv -1 0 0\nv 0 0 1\nv 0 0 -1\nv 0 2 0\nf 1 3 5\nf 2 4 5\n");
    World world(
        parse_scene(R"({"meshes": [{"file": ")" + file + "\", " + more + "}]}", "s.json"));
    world.move_to(time);
    return world.mesh().positions.at(0);
}

void expect_near(glm::vec3 found, glm::vec3 right) {
    EXPECT_LT(glm::distance(found, right), 1e-5f)
        << found.x << ' ' << found.y << ' ' << found.z << " instead of " << right.x << ' '
        << right.y << ' ' << right.z;
}

TEST(Rotation, KeysOfASceneTurnAsTheyWereAsked) {
    const auto keys = [](const char* degrees) {
        return R"("keys": [{"time": 0}, {"time": 4, "rotate": {"axis": [0, 1, 0], "degrees": )" +
               std::string(degrees) + "}}]";
    };
    expect_near(corner_at(keys("360"), 1), {0, 0, -1});
    expect_near(corner_at(keys("360"), 2), {-1, 0, 0});
    expect_near(corner_at(keys("-360"), 1), {0, 0, 1});
    expect_near(corner_at(keys("270"), 2), {-std::sqrt(0.5f), 0, -std::sqrt(0.5f)});
    expect_near(corner_at(keys("720"), 1), {-1, 0, 0});
    expect_near(corner_at(keys("720"), 4), {1, 0, 0});
}

// The mesh is 2 high and 2 wide, so that it stands with its own size.
TEST(Rotation, KeysTurnAMeshWhereItStands) {
    const std::string stand = R"("stand": {"at": [5, 1, -3], "height": 2}, )";
    expect_near(corner_at(stand + R"("keys": [{"time": 0, "rotate": {"axis": [0, 1, 0],
                          "degrees": 90}}])",
                          0),
                {5, 1, -4});
    expect_near(corner_at(stand + R"("keys": [{"time": 0, "scale": 3}])", 0), {8, 1, -3});
    expect_near(corner_at(stand + R"("keys": [{"time": 0, "translate": [0, 0, 7]}])", 0),
                {6, 1, 4});
    // Without a place to stand on, keys turn about the world's origin.
    expect_near(corner_at(R"("transform": {"translate": [5, 1, -3]}, "keys": [{"time": 0,
                          "rotate": {"axis": [0, 1, 0], "degrees": 90}}])",
                          0),
                {-3, 1, -6});
}

}  // namespace
}  // namespace render
