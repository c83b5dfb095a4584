// spawn_faults_test.cpp - spawned rays that are right, and each way to be wrong, from outside and
// inside of a glass cube; and which of them leak. Needs no device.
#include "stability/spawned/spawn_faults.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "stability/tally.hpp"
#include "support/bodies.hpp"

namespace {

using namespace bench::stability;
using test::Float3;

constexpr float kUlp = 0x1p-23f;

rsh_material mirror() {
    rsh_material material = {};
    material.reflection = {{1, 1, 1, 0}};
    return material;
}

// A cube of mirrors, and a ray that is mirrored where x = 1: from inside.
struct Case {
    Scene scene;
    Spawned spawned;
};

Case mirrored_inside() {
    Case c;
    c.scene.mesh = test::placed(test::box_body({1, 1, 1}), {});
    c.scene.spawning =
        Spawning{{RSH_SPAWN_REFLECTION}, {mirror()}, std::vector<uint32_t>(12, 0), rsh_light{}};
    c.spawned.seen = {{test::make_ray({0, -0.5f, -0.25f}, {1, 0, 0})}, 1, 1};
    c.spawned.hits = {{1, 0.25f, 0.375f, 10}};  // (1 -1 -1), (1 1 -1), (1 -1 1)
    c.spawned.weights = {{{1, 1, 1, 0}}};
    c.scene.rays = {{test::make_ray({1 - kUlp, -0.5f, -0.25f}, {-1, 0, 0})}, 1, 1, {10}};
    return c;
}

SpawnFaults faults_of(const Case& c) {
    return spawn_faults(c.scene, c.spawned, 1);
}

TEST(SpawnFaults, AreNoneOfRightRays) {
    const SpawnFaults faults = faults_of(mirrored_inside());
    EXPECT_EQ(faults.missed + faults.spurious + faults.nan_out, 0u) << faults.first;
}

TEST(SpawnFaults, CountEachByItsName) {
    Case behind = mirrored_inside();
    behind.scene.rays.rays[0].origin_tmin.s[0] = 1;
    EXPECT_EQ(faults_of(behind).missed, 1u);

    Case far = mirrored_inside();
    far.scene.rays.rays[0].origin_tmin.s[0] = 0.9999f;
    EXPECT_EQ(faults_of(far).spurious, 1u);

    Case wrong = mirrored_inside();
    wrong.scene.rays.rays[0].direction_tmax.s[1] = 1e-5f;
    EXPECT_EQ(faults_of(wrong).spurious, 1u);

    Case nan = mirrored_inside();
    nan.spawned.weights[0].s[0] = NAN;
    EXPECT_EQ(faults_of(nan).nan_out, 1u);

    Case from_nothing = mirrored_inside();
    from_nothing.spawned.hits[0].primitive = RSH_NO_HIT;
    EXPECT_EQ(faults_of(from_nothing).spurious, 1u);
    EXPECT_NE(faults_of(from_nothing).first.find("has hit nothing"), std::string::npos);
}

// On the right side of its triangle, and yet outside: allowed near an edge alone.
TEST(SpawnFaults, TellWhatBeginsOutside) {
    Case beside = mirrored_inside();
    beside.scene.rays.rays[0].origin_tmin.s[1] = -1.001f;
    EXPECT_EQ(faults_of(beside).missed, 1u);
    EXPECT_NE(faults_of(beside).first.find("outside"), std::string::npos);

    Case at_edge = mirrored_inside();
    at_edge.scene.rays.rays[0].origin_tmin.s[1] = -1 - kUlp;
    EXPECT_EQ(faults_of(at_edge).missed, 0u) << faults_of(at_edge).first;
}

Tally tally_of(const Scene& scene, const rsh_hit& hit) {
    Tally tally;
    tally.add_hits(scene, expected_answers(scene, Kind::kSpawned, 1), {hit}, {hit});
    return tally;
}

TEST(Spawned, LeaksFromInsideAlone) {
    const rsh_hit nothing = {INFINITY, 0, 0, RSH_NO_HIT};
    Scene scene = mirrored_inside().scene;
    // At an edge of two triangles, so that neither hit is certain.
    scene.rays.rays[0] = test::make_ray({0, 0, 0}, {-1, 0, 0});
    EXPECT_EQ(tally_of(scene, nothing).metrics()["missed"], 1);
    scene.rays.rays[0] = test::make_ray({-2, 0, 0}, {-1, 0, 0});
    EXPECT_EQ(tally_of(scene, nothing).metrics()["missed"], 0);
    // The way out is where the ray begins.
    scene.rays.rays[0] = test::make_ray({-1 + 0x1p-24f, 0, 0}, {-0.5f, 1, 0});
    EXPECT_EQ(tally_of(scene, nothing).metrics()["missed"], 0);
}

// A triangle in the plane of the one left, or behind that.
TEST(Spawned, HitsNothingBehindItself) {
    Scene scene = mirrored_inside().scene;
    const rsh_hit neighbour = {0, 0.5f, 0.5f, 11};
    EXPECT_EQ(tally_of(scene, neighbour).metrics()["self_hits"], 1);
    EXPECT_NE(tally_of(scene, neighbour).metrics()["why"].get<std::string>().find("leaves 10"),
              std::string::npos);
    const rsh_hit other_side = {2 - kUlp, 0.5f, 0.5f, 8};
    EXPECT_EQ(tally_of(scene, other_side).metrics()["self_hits"], 0);
}

}  // namespace
