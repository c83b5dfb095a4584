// mirrors_test.cpp - chains of mirrored rays between curved mirrors, where each error grows
// from bounce to bounce: beside paths in 113 bits, and beside the best that a state of floats
// can do.
#include <gtest/gtest.h>

#include "oracle/mirrors/float_state.hpp"
#include "oracle/mirrors/lines.hpp"
#include "support/render.hpp"
#include "support/trace.hpp"

namespace {

using oracle::Followed;
using oracle::MirrorRoom;
using oracle::Wave;
using test::Float3;

test::Scene scene_of(const MirrorRoom& room) {
    test::Scene scene;
    scene.mesh = room.mesh;
    scene.normals = room.normals;
    scene.materials = {oracle::mirror_material()};
    return scene;
}

class ByRsh final : public oracle::Tracer {
public:
    explicit ByRsh(const MirrorRoom& room) : mesh_(room.mesh), scene_(scene_of(room)) {}

    std::vector<rsh_hit> closest(const std::vector<rsh_ray>& rays,
                                 const std::vector<uint32_t>& skip) override {
        return closest_hits(mesh_, {rays, uint32_t(rays.size()), 1, skip});
    }
    Wave mirrored(const Wave& wave) override {
        const test::Spawned spawned = test::spawn(scene_, wave.rays, wave.hits, {});
        return {spawned.rays, spawned.skip, {}};
    }

private:
    test::DeviceMesh mesh_;
    test::DeviceScene scene_;
};

struct Place {
    float scale = 1;
    Float3 offset = {};  // in radii of the room
};

MirrorRoom room_at(const Place& place, bool is_smooth) {
    MirrorRoom room = oracle::mirror_room(test::small() ? 1 : 3, is_smooth);
    room.mesh = test::scaled(room.mesh, place.scale, place.scale * place.offset);
    return room;
}

std::vector<rsh_ray> rays_at(const Place& place) {
    test::Random random(12);
    const auto rays = oracle::rays_in_mirror_room(random, test::small() ? 32 : 256);
    return test::scaled({rays, uint32_t(rays.size()), 1, {}}, place.scale,
                        place.scale * place.offset)
        .rays;
}

void expect_near_the_best(bool is_smooth, const Place& place = {}) {
    const MirrorRoom room = room_at(place, is_smooth);
    ByRsh tracer(room);
    const uint32_t bounces = test::small() ? 4 : 16;
    const Followed found = follow(room, place.scale, rays_at(place), bounces, tracer);
    const size_t paths = found.growth.size();
    for (size_t bounce = 1; bounce <= bounces; ++bounce) {
        ASSERT_LT(2 * found.lines[oracle::kBestFloats].lost_by(bounce), paths)
            << "half of the best paths have parted by bounce " << bounce;
        EXPECT_LE(times_the_best(found, bounce), 2)
            << "times the error of the best floats in the median of " << paths
            << " paths, after bounce " << bounce;
    }
    EXPECT_EQ(found.faults.nan, 0u);
    EXPECT_EQ(found.faults.self_hits, 0u);
    EXPECT_EQ(found.faults.leaks, 0u);
}

// The line of the offset alone tells what rsh's rays err by only if they begin where it says.
TEST(Mirrors, LetRaysBeginWhereTheRuleSays) {
    const MirrorRoom room = room_at({}, true);
    const oracle::Mirrors mirrors(room.mesh, room.normals);
    ByRsh tracer(room);
    const auto waves = oracle::trace_waves(tracer, rays_at({}), 4);
    size_t same = 0, all = 0;
    for (size_t k = 1; k < waves.size(); ++k)
        for (size_t i = 0; i < waves[k].rays.size(); ++i) {
            const oracle::MirrorRay before = ray_of(waves[k - 1], i);
            const uint32_t triangle = waves[k].skip[i];
            const oracle::Quad3 hit = mirrors.point_in_plane(before, triangle);
            const oracle::MirrorRay exact = mirrors.reflected(before, {triangle, hit});
            const Float3 expected(departed(exact, mirrors.normal_towards(exact)).origin);
            const Float3 found = test::origin(waves[k].rays[i]);
            same += found.x == expected.x && found.y == expected.y && found.z == expected.z;
            ++all;
        }
    // The others are as good within rounding.
    EXPECT_GE(double(same), 0.98 * double(all)) << "of " << all << " origins";
}

TEST(Mirrors, KeepToThePathAsTheBestFloatsDo) {
    expect_near_the_best(true);
}

TEST(Mirrors, KeepToThePathWithoutNormals) {
    expect_near_the_best(false);
}

TEST(Mirrors, KeepToThePathFarFromTheOrigin) {
    expect_near_the_best(true, {1, {3, -5, 2}});
}

TEST(Mirrors, KeepToThePathAtAnyScale) {
    for (const float scale : {3e-12f, 7e10f}) {
        SCOPED_TRACE("scale " + std::to_string(scale));
        expect_near_the_best(true, {scale, {}});
    }
}

}  // namespace
