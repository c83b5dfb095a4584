// leaving_oracle_test.cpp - the judges of spawned rays judged: right rays pass, and each wrong one
// is told by its fault. Needs no device.
#include <gtest/gtest.h>

#include "oracle/exact.hpp"
#include "oracle/leaving/inside.hpp"
#include "oracle/leaving/separated.hpp"
#include "oracle/leaving/snell.hpp"
#include "oracle/leaving/spawned_ray.hpp"
#include "support/bodies.hpp"

namespace {

using oracle::Fault;
using test::Corners;
using test::Float3;
using test::Long3;

Corners ground() {
    return {Float3(-4, 0, -4), Float3(0, 0, 4), Float3(4, 0, -4)};  // +y is outside
}

TEST(SideOfPlane, IsExact) {
    const Corners c = {Float3(0.1f, 0.3f, 0.7f), Float3(1.1f, 0.7f, 0.3f),
                       Float3(0.3f, 1.3f, 0)};
    for (const Float3 corner : c) EXPECT_EQ(oracle::side_of_plane(corner, c), 0);
    EXPECT_EQ(oracle::side_of_plane({0, 0x1p-149f, 0}, ground()), 1);
    EXPECT_EQ(oracle::side_of_plane({0, -0x1p-149f, 0}, ground()), -1);
    EXPECT_EQ(oracle::side_of_plane({0x1p100f, 0, -0x1p-100f}, ground()), 0);
}

TEST(Inside, IsWithinEveryBodyAndNotOnIt) {
    test::Random random(1);
    for (const test::Body& body :
         {test::box_body({1, 1, 1}), test::sphere_body(10, 5), test::wedge(1), test::wedge(179),
          test::dart(1), test::dart(90), test::dart(179), test::frustum(0.01)}) {
        test::Placement at;
        at.turn = test::random_turn(random);
        const test::Mesh mesh = placed(body, at);
        for (const Float3 corner : mesh.vertices) {
            EXPECT_FALSE(oracle::is_inside(mesh, corner));
            EXPECT_FALSE(oracle::is_inside(mesh, 1.001f * corner));
        }
        Corners c;  // every body's triangles turn outwards
        for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
            ASSERT_TRUE(mesh.corners(i, &c));
            const Float3 middle = (1.0f / 3) * (c[0] + c[1] + c[2]);
            const Float3 out = normalize(cross(c[1] - c[0], c[2] - c[0]));
            EXPECT_TRUE(oracle::is_inside(mesh, middle - 1e-4f * out)) << i;
            EXPECT_FALSE(oracle::is_inside(mesh, middle + 1e-4f * out)) << i;
        }
    }
}

TEST(Separated, IsWhatARayHasBehindItself) {
    const rsh_ray up = test::make_ray({0, 0x1p-20f, 0}, {0.5f, 1, 0});
    const Corners beside = {Float3(-4, 0, -4), Float3(4, 0, -4), Float3(0, 0, -8)};
    Corners behind = beside, before = beside;
    for (Float3& corner : behind) corner.y = -1;
    for (Float3& corner : before) corner.y = 0x1p-19f;
    EXPECT_TRUE(oracle::is_separated(up, ground(), beside));
    EXPECT_TRUE(oracle::is_separated(up, ground(), behind));
    EXPECT_FALSE(oracle::is_separated(up, ground(), before));
    EXPECT_FALSE(oracle::is_separated(test::make_ray({0, 1, 0}, {0, -1, 0}), ground(), beside));
    // Where another triangle begins, it may be hit.
    const Corners wall = {Float3(0, -1, -1), Float3(0, -1, 1), Float3(0, 3, 0)};
    EXPECT_FALSE(oracle::is_separated(up, ground(), wall));
    EXPECT_TRUE(
        oracle::is_separated(test::make_ray({0x1p-20f, 0, 0}, {0.5f, 1, 0}), ground(), wall));
}

// A ray that hits the ground at 0, from above or below, with that sine.
oracle::Sight sight(double sine, bool is_above, float index) {
    const double cosine = std::sqrt(1 - sine * sine);
    const Float3 d(float(sine), float(is_above ? -cosine : cosine), 0);
    rsh_material material = {};
    material.transmission = {{1, 1, 1, index}};
    return {test::make_ray(-1.0f * d, d), {1, 0.25f, 0.5f, 0}, ground(), material};
}

oracle::SpawnedRay none() {
    oracle::SpawnedRay none = {};
    none.ray.direction_tmax.s[3] = -1;
    none.skip = RSH_NO_HIT;
    return none;
}

oracle::SpawnedRay spawned(Float3 origin, Long3 direction, float weight) {
    return {test::make_ray(origin, Float3(direction)), {{weight, weight, weight, 0}}, 0};
}

oracle::SpawnedRay right_refraction(const oracle::Sight& from) {
    const auto at = oracle::plane_hit(from.ray, from.corners);
    const auto snell = oracle::snell_at(at, from.material.transmission.s[3]);
    return spawned({0, at.is_outside ? -0x1p-40f : 0x1p-40f, 0}, refracted(at, snell), 0.9f);
}

oracle::SpawnedRay right_reflection(const oracle::Sight& from, float weight) {
    const auto at = oracle::plane_hit(from.ray, from.corners);
    return spawned({0, at.is_outside ? 0x1p-40f : -0x1p-40f, 0}, mirrored(at), weight);
}

TEST(Snell, KnowsTheCriticalAngle) {
    for (const float index : {1.0001f, 1.5f, 3.0f}) {
        for (const double ulps : {-1024.0, 1024.0}) {
            const auto from = sight(1 / double(index) * (1 + ulps * 0x1p-24), false, index);
            const auto snell = snell_at(oracle::plane_hit(from.ray, from.corners), index);
            EXPECT_EQ(snell.is_refracted, ulps < 0) << index;
            EXPECT_EQ(snell.is_total, ulps > 0) << index;
        }
        const auto open = sight(1 / double(index), false, index);
        const auto snell = snell_at(oracle::plane_hit(open.ray, open.corners), index);
        EXPECT_FALSE(snell.is_refracted || snell.is_total) << index;
        EXPECT_LT(snell.error, 1e-5L);
    }
    const auto flat = sight(0.6, true, 1.5f);
    const auto at = oracle::plane_hit(flat.ray, flat.corners);
    EXPECT_NEAR(double(refracted(at, snell_at(at, 1.5f)).x), 0.4, 1e-7);
    EXPECT_NEAR(double(snell_at(at, 1.5f).reflectance), 0.043895, 1e-5);
}

TEST(Snell, TakesWhatIsNoIndexForOne) {
    const auto from = sight(0.6, false, 1);
    for (const float index :
         {0.0f, -1.5f, -0.0f, float(INFINITY), -float(INFINITY), float(NAN)})
        EXPECT_EQ(snell_at(oracle::plane_hit(from.ray, from.corners), index).eta, 1);
}

TEST(SpawnedRay, MayBeRight) {
    for (const bool is_above : {true, false}) {
        const auto from = sight(0.4, is_above, 1.5f);
        EXPECT_EQ(judge_refracted(from, right_refraction(from)).why, "");
        EXPECT_EQ(judge_reflected(from, right_reflection(from, 0.1f)).why, "");
    }
    const auto total = sight(0.9, false, 1.5f);
    EXPECT_EQ(judge_refracted(total, none()).why, "");
    EXPECT_EQ(judge_reflected(total, right_reflection(total, 1)).why, "");
}

TEST(SpawnedRay, MustBeThereOrNot) {
    const auto from = sight(0.4, false, 1.5f), total = sight(0.9, false, 1.5f);
    EXPECT_EQ(judge_refracted(from, none()).fault, Fault::kMissed);
    EXPECT_EQ(judge_reflected(total, none()).fault, Fault::kMissed);
    EXPECT_EQ(judge_reflected(total, right_reflection(total, 0.9f)).fault, Fault::kSpurious);
    EXPECT_EQ(judge_refracted(total, right_refraction(total)).fault, Fault::kSpurious);
    auto opaque = from;
    opaque.material = {};
    EXPECT_EQ(judge_refracted(opaque, right_refraction(from)).fault, Fault::kSpurious);
    EXPECT_EQ(judge_reflected(opaque, right_reflection(from, 1)).fault, Fault::kSpurious);
}

TEST(SpawnedRay, StartsOnItsSideAndNoFarther) {
    const auto from = sight(0.4, true, 1.5f);
    for (const float height : {0.0f, -0x1p-149f, 1e-6f, -1e-6f}) {
        auto ray = right_reflection(from, 0.1f);
        ray.ray.origin_tmin.s[1] = height;
        EXPECT_EQ(judge_reflected(from, ray).fault,
                  height > 0 ? Fault::kSpurious : Fault::kMissed)
            << height;
    }
}

TEST(SpawnedRay, HasTheRightDirection) {
    const auto from = sight(0.4, true, 1.5f);
    const auto turned = [](oracle::SpawnedRay ray, float by) {
        ray.ray.direction_tmax.s[2] += by;
        return ray;
    };
    EXPECT_EQ(judge_reflected(from, turned(right_reflection(from, 0.1f), 1e-6f)).fault,
              Fault::kSpurious);
    EXPECT_EQ(judge_refracted(from, turned(right_refraction(from), 1e-4f)).fault,
              Fault::kSpurious);
    auto longer = right_reflection(from, 0.1f);
    for (int i = 0; i < 3; ++i) longer.ray.direction_tmax.s[i] *= 1.00001f;
    EXPECT_EQ(judge_reflected(from, longer).fault, Fault::kSpurious);
}

TEST(SpawnedRay, TellsNaN) {
    auto ray = right_reflection(sight(0.4, true, 1.5f), 0.1f);
    EXPECT_FALSE(has_nan(ray));
    ray.weight.s[1] = NAN;
    EXPECT_TRUE(has_nan(ray));
}

TEST(SpawnedRay, RunsToTheLight) {
    const auto from = sight(0.4, true, 1.5f);
    rsh_light light = {};
    light.position = {{1, 2, 3, 0}};
    auto ray = spawned({0, 0x1p-40f, 0}, Long3(1, 2, 3), 0);
    ray.ray.direction_tmax.s[3] = 1 - 0x1p-16f;
    EXPECT_EQ(judge_shadow(from, light, ray).why, "");
    EXPECT_EQ(judge_shadow(from, light, none()).fault, Fault::kMissed);
    auto longer = ray;
    longer.ray.direction_tmax.s[3] = 1;
    EXPECT_EQ(judge_shadow(from, light, longer).fault, Fault::kSpurious);
    auto beside = ray;
    beside.ray.direction_tmax.s[0] = 1 + 0x1p-23f;
    EXPECT_EQ(judge_shadow(from, light, beside).fault, Fault::kSpurious);
    light.position.s[1] = -2;
    EXPECT_EQ(judge_shadow(from, light, ray).fault, Fault::kSpurious);
    EXPECT_EQ(judge_shadow(from, light, none()).why, "");
}

}  // namespace
