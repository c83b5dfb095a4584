// crossings_test.cpp - counts and lists of all hits against the oracles: in every case what double
// precision leaves no doubt of, and on lattices each pair, by every way to traverse.
#include <gtest/gtest.h>

#include <algorithm>

#include "oracle/accepts.hpp"
#include "support/cases.hpp"
#include "support/compare.hpp"
#include "support/ways.hpp"

namespace {

using test::DeviceMesh;
using test::Float3;
using test::HitLists;
using test::Mesh;
using test::Random;
using test::Rays;
using test::TraceOptions;

class CrossingsOfCases : public ::testing::TestWithParam<test::NamedCase> {
protected:
    Random random_{61};
    const test::Case case_ = GetParam().make(random_);
    const DeviceMesh mesh_{case_.mesh};
    const HitLists lists_ = all_hits(mesh_, case_.rays, test::brute_force());
};

TEST_P(CrossingsOfCases, AreThoseOfTheOracle) {
    const std::vector<rsh_ray>& rays = case_.rays.rays;
    const auto expected = oracle::crossings(case_.mesh, rays, case_.rays.skip);
    EXPECT_TRUE(oracle::all_hits_are_correct(expected, rays, lists_.offsets, lists_.hits));
    EXPECT_TRUE(oracle::counts_are_correct(expected, rays,
                                           hit_counts(mesh_, case_.rays, test::brute_force())));
}

// Where no other is possible, bit by bit.
TEST_P(CrossingsOfCases, BeginWithTheClosest) {
    const auto answers = oracle::closest(case_.mesh, case_.rays.rays, case_.rays.skip);
    std::vector<rsh_hit> first, closest;
    const auto hits = closest_hits(mesh_, case_.rays, test::brute_force());
    for (size_t i = 0; i < hits.size(); ++i) {
        if (answers[i].ambiguous || answers[i].primitive == RSH_NO_HIT) continue;
        ASSERT_LT(lists_.offsets[i], lists_.offsets[i + 1]) << "ray " << i;
        first.push_back(lists_.hits[lists_.offsets[i]]);
        closest.push_back(hits[i]);
    }
    EXPECT_TRUE(test::same_bits(first, closest, "hits"));
}

INSTANTIATE_TEST_SUITE_P(All, CrossingsOfCases, ::testing::ValuesIn(test::all_cases()),
                         test::case_name);

constexpr int kHalf = 8;  // of the cube that holds corners and origins

Float3 lattice_point(Random& random) {
    const auto one = [&] { return float(random.below(2 * kHalf + 1)) - float(kHalf); };
    return {one(), one(), one()};
}

Float3 lattice_direction(Random& random) {
    const auto one = [&] {
        const float size[] = {0.0f, 1.0f, 2.0f, 4.0f};
        return (random.chance(0.5f) ? 1.0f : -1.0f) * size[random.below(4)];
    };
    for (;;) {
        const Float3 d(one(), one(), one());
        if (max_norm(d) > 0) return d;
    }
}

// Anywhere, flat and empty ones among them.
Mesh lattice_soup(Random& random, uint32_t count) {
    Mesh mesh;
    for (uint32_t i = 0; i < count; ++i) {
        const Float3 a = lattice_point(random), b = lattice_point(random);
        mesh.add(a, b, random.chance(0.05f) ? a : lattice_point(random));
    }
    return mesh;
}

Mesh stacked_copies(Random& random, uint32_t count) {
    return test::turned_copies(random, lattice_soup(random, count / 8), count);
}

// Through corners, along edges, in the planes of faces, and through anything.
Rays lattice_rays(Random& random, const Mesh& mesh, uint32_t width, uint32_t height) {
    Rays rays{{}, width, height};
    for (uint32_t i = 0; i < width * height; ++i) {
        test::Corners c;
        mesh.corners(random.below(mesh.triangle_count()), &c);
        Float3 d = lattice_direction(random), to = c[random.below(3)];
        const uint32_t kind = random.below(4);
        if (kind == 0) to = lattice_point(random);
        if (kind == 1) d = {0, 0, 0}, (&d.x)[random.below(3)] = -1;
        // From a corner, or from up to 15 steps before it.
        rays.rays.push_back(test::make_ray(to - float(random.below(16)) * d, d));
    }
    return rays;
}

struct Lattice {
    const char* name;
    Mesh (*make)(Random&, uint32_t);
};

void PrintTo(const Lattice& lattice, std::ostream* out) {
    *out << lattice.name;
}

class CrossingsOfLattices : public ::testing::TestWithParam<Lattice> {};

TEST_P(CrossingsOfLattices, AreThoseOfTheOracle) {
    Random random(62);
    const Mesh host = GetParam().make(random, test::small() ? 60 : 400);
    const DeviceMesh mesh(host);
    Rays rays = lattice_rays(random, host, test::small() ? 8 : 48, test::small() ? 6 : 40);
    const auto expected = oracle::lattice_crossings(host, rays.rays);
    size_t crossed = 0;
    for (const oracle::Crossings& one : expected) crossed += one.size();
    EXPECT_GT(crossed, rays.rays.size()) << "hardly a ray crosses anything";
    for (const bool is_list : {false, true}) {
        if (is_list) rays.width *= rays.height, rays.height = 1;
        for (const TraceOptions& way : test::brute_force_and_all_ways()) {
            SCOPED_TRACE(name_of(way) + (is_list ? ", list" : ", grid"));
            const HitLists lists = all_hits(mesh, rays, way);
            EXPECT_TRUE(
                oracle::all_hits_are_correct(expected, rays.rays, lists.offsets, lists.hits));
            EXPECT_TRUE(
                oracle::counts_are_correct(expected, rays.rays, hit_counts(mesh, rays, way)));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, CrossingsOfLattices,
                         ::testing::Values(Lattice{"Soup", lattice_soup},
                                           Lattice{"Copies", stacked_copies}),
                         [](const auto& named) { return named.param.name; });

// Bounded from their common end, and each without a triangle of its own.
TEST(CrossingsOfShadowRays, AreThoseOfTheOracle) {
    Random random(63);
    const Mesh host = test::random_soup(random, test::small() ? 60 : 500);
    Rays rays = test::converging_rays(random, test::small() ? 8 : 40, 31, {0.1f, 0.2f, 0.3f});
    for (size_t i = 0; i < rays.rays.size(); ++i)
        rays.skip.push_back(random.below(host.triangle_count()));
    const auto expected = oracle::crossings(host, rays.rays, rays.skip);
    for (TraceOptions way : test::brute_force_and_all_ways()) {
        SCOPED_TRACE(name_of(way));
        way.converging = true;
        const HitLists lists = all_hits(DeviceMesh(host), rays, way);
        EXPECT_TRUE(
            oracle::all_hits_are_correct(expected, rays.rays, lists.offsets, lists.hits));
    }
}

}  // namespace
