// limits_test.cpp - where floats end (docs/numerics.md, "Limits"): up to there every way to traverse
// hits, and beyond it none does.
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

#include "support/ways.hpp"

namespace {

using test::Float3;
using test::Mesh;
using test::Rays;

Mesh triangle(Float3 a, Float3 b, Float3 c) {
    Mesh mesh;
    mesh.add(a, b, c);
    return mesh;
}

// Whether the ray hits the only triangle; all ways must agree.
bool is_hit(const Mesh& mesh, const rsh_ray& ray) {
    const test::DeviceMesh scene(mesh);
    const Rays rays{{ray}, 1, 1};
    const auto expected = closest_hits(scene, rays, test::brute_force()).front();
    for (const test::TraceOptions& way : test::all_ways()) {
        const auto found = closest_hits(scene, rays, way).front();
        EXPECT_EQ(found.primitive, expected.primitive) << name_of(way);
        EXPECT_EQ(found.t, expected.t) << name_of(way);
    }
    return expected.primitive == 0;
}

TEST(FloatLimits, OfDirectionsLieAtTheReciprocalThatOverflows) {
    const Mesh mesh = triangle({-1, -1, 1}, {1, -1, 1}, {0, 1, 1});
    for (const int power : {-100, -120, -126})
        EXPECT_TRUE(is_hit(mesh, test::make_ray({}, {0, 0, std::ldexp(1.0f, power)})))
            << "2^" << power;
    for (const int power : {-128, -130, -149})
        EXPECT_FALSE(is_hit(mesh, test::make_ray({}, {0, 0, std::ldexp(1.0f, power)})))
            << "2^" << power;
}

// As wide as 1, as high as 2^power.
bool is_needle_hit(int power) {
    const float height = std::ldexp(1.0f, power);
    return is_hit(triangle({0, 0, 1}, {1, 0, 1}, {0, height, 1}),
                  test::make_ray({0.25f, 0.25f * height, 0}, {0, 0, 1}));
}

TEST(FloatLimits, OfNeedlesLieAtTheAreaThatUnderflows) {
    for (const int power : {-20, -60, -90, -102})
        EXPECT_TRUE(is_needle_hit(power)) << "2^" << power;
    for (const int power : {-103, -110, -126})
        EXPECT_FALSE(is_needle_hit(power)) << "2^" << power;
}

TEST(FloatLimits, OfCornersLieWhereDifferencesOverflow) {
    const float most = FLT_MAX;
    const Mesh mesh = triangle({-most, -most, 1}, {most, -most, 1}, {0, most, 1});
    EXPECT_TRUE(is_hit(mesh, test::make_ray({}, {0, 0, 1})));
    EXPECT_FALSE(is_hit(mesh, test::make_ray({-most, -most, 0}, {0, 0, 1})));
}

}  // namespace
