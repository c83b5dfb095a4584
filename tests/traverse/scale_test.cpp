// scale_test.cpp - hits do not depend on the scene's unit: no way to traverse loses one, however
// small or large triangles and distances are.
#include <gtest/gtest.h>

#include <cmath>

#include "support/compare.hpp"
#include "support/ways.hpp"

namespace {

using test::Float3;
using test::Mesh;
using test::Rays;

// Equal-sided, 1 from the centre to a corner, the centre within `off` of the origin.
Mesh triangles_around_origin(test::Random& random, uint32_t count, float off) {
    Mesh mesh;
    while (mesh.triangle_count() < count) {
        const Float3 x = normalize(random.direction());
        const Float3 y = normalize(cross(x, random.direction()));
        const Float3 at = off * random.in_cube();
        const float half = 0.5f, side = 0.8660254f;
        mesh.add(at + x, at - half * x + side * y, at - half * x - side * y);
    }
    return mesh;
}

// Near a corner, where the bounds are tightest.
Float3 point_of(test::Random& random, const Mesh& mesh) {
    test::Corners c;
    mesh.corners(random.below(mesh.triangle_count()), &c);
    const Float3 centre = (1 / 3.0f) * (c[0] + c[1] + c[2]);
    return centre + (1 - std::exp2(random.between(-20, 0))) * (c[random.below(3)] - centre);
}

enum class Kind { pinhole, scattered, parallel };

// From `distance` to points of the mesh: from one eye, from all around, or along z.
Rays rays_to(const Mesh& mesh, test::Random& random, uint32_t side, float distance, Kind kind) {
    Rays rays{{}, side, side};
    const Float3 eye = distance * normalize(random.direction());
    for (uint32_t i = 0; i < side * side; ++i) {
        const Float3 at = point_of(random, mesh);
        const Float3 d = kind == Kind::pinhole    ? normalize(at - eye)
                         : kind == Kind::parallel ? Float3(0, 0, -1)
                                                  : normalize(random.direction());
        rays.rays.push_back(test::make_ray(kind == Kind::pinhole ? eye : at - distance * d, d));
    }
    return rays;
}

// Directions keep their length.
Rays moved_to_scale(Rays rays, float scale) {
    for (rsh_ray& ray : rays.rays)
        for (int axis = 0; axis < 3; ++axis) ray.origin_tmin.s[axis] *= scale;
    return rays;
}

Rays from_z_of_one(Rays rays) {
    for (rsh_ray& ray : rays.rays) ray.origin_tmin.s[2] = 1;
    return rays;
}

// Returns how many there are to lose.
size_t expect_no_hit_lost(const test::DeviceMesh& mesh, const Rays& rays) {
    const auto expected = closest_hits(mesh, rays, test::brute_force());
    for (test::TraceOptions way : test::all_ways())
        for (const bool converging : {false, true}) {
            way.converging = converging;
            EXPECT_TRUE(test::same_bits(closest_hits(mesh, rays, way), expected, "hits"))
                << name_of(way) << (converging ? ", converging" : "");
        }
    size_t hits = 0;
    for (const rsh_hit& hit : expected) hits += hit.primitive != RSH_NO_HIT;
    return hits;
}

// scale: distance from a triangle's centre to its corners; distance: in these.
size_t expect_no_hit_lost_at(float scale, float distance, test::Random& random) {
    const uint32_t side = test::small() ? 8 : 72;
    const Mesh mesh =
        triangles_around_origin(random, test::small() ? 4 : 20, float(random.below(3)));
    const test::DeviceMesh scene(scaled(mesh, scale));
    size_t hits = 0;
    for (const Kind kind : {Kind::pinhole, Kind::scattered, Kind::parallel}) {
        SCOPED_TRACE("kind " + std::to_string(int(kind)) + ", scale 10^" +
                     std::to_string(std::log10(scale)) + ", distance " +
                     std::to_string(distance));
        const Rays rays = rays_to(mesh, random, side, distance, kind);
        hits += expect_no_hit_lost(scene, scaled(rays, scale));
        hits += expect_no_hit_lost(scene, moved_to_scale(rays, scale));
        if (kind == Kind::parallel)
            hits += expect_no_hit_lost(scene, from_z_of_one(scaled(rays, scale)));
    }
    return hits;
}

// Where squares of sizes are denormal, or 0.
TEST(Scale, OfSquaresThatUnderflowLosesNoHit) {
    test::Random random(70);
    for (float exponent = -24; exponent <= -18; exponent += test::small() ? 2.25f : 0.25f)
        for (const float distance : {1.5f, 4000.0f})
            EXPECT_GT(expect_no_hit_lost_at(std::pow(10.0f, exponent), distance, random), 0u);
}

TEST(Scale, OfAnySizeLosesNoHit) {
    test::Random random(71);
    size_t hits = 0;
    for (int i = 0; i < (test::small() ? 2 : 40); ++i) {
        const float scale = std::pow(10.0f, random.between(-30, 30));
        const float distance = std::exp2(random.between(0, 16));
        hits += expect_no_hit_lost_at(scale, distance, random);
    }
    EXPECT_GT(hits, 0u);
}

// Pairs of the engine whose nodes and spheres are told apart by squares.
std::vector<cl_ulong> pairs_tested(const Mesh& mesh, const Rays& rays) {
    test::TraceOptions options;
    options.engine = RSH_ENGINE_PAPER_FAITHFUL;
    const rsh_statistics s = test::statistics_of(test::DeviceMesh(mesh), rays, options);
    return std::vector<cl_ulong>(std::begin(s.pairs_tested), std::end(s.pairs_tested));
}

TEST(Scale, ByPowersOfTwoChangesNoDecision) {
    test::Random random(72);
    const Mesh mesh = test::random_soup(random, test::small() ? 40 : 400, 0.1f);
    const Rays rays = test::pinhole_rays(32, 32);
    const auto expected = pairs_tested(mesh, rays);
    EXPECT_GT(expected[0], 0u);
    for (const int exponent : {-78, -60, 50, 90}) {
        const float scale = std::ldexp(1.0f, exponent);
        EXPECT_EQ(pairs_tested(scaled(mesh, scale), moved_to_scale(rays, scale)), expected)
            << "scale 2^" << exponent;
    }
}

}  // namespace
