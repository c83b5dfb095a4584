// all_hits_test.cpp - counts and lists of all hits: every way to traverse gives the bits of brute
// force, in order, and tells the true number where they do not fit. oracle/ tests what they are.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/compare.hpp"
#include "support/ways.hpp"
#include "traverse/types.h"
#include "tuning.h"

namespace {

using test::DeviceMesh;
using test::HitLists;
using test::TraceOptions;

std::vector<uint32_t> counts_of(const HitLists& lists) {
    std::vector<uint32_t> counts;
    for (size_t i = 1; i < lists.offsets.size(); ++i)
        counts.push_back(uint32_t(lists.offsets[i] - lists.offsets[i - 1]));
    return counts;
}

bool comes_before(const rsh_hit& a, const rsh_hit& b) {
    return a.t < b.t || (a.t == b.t && a.primitive < b.primitive);
}

class AllHits : public ::testing::TestWithParam<test::NamedCase> {
protected:
    test::Random random_{51};
    const test::Case case_ = GetParam().make(random_);
    const DeviceMesh mesh_{case_.mesh};
    const HitLists expected_ = all_hits(mesh_, case_.rays, test::brute_force());
};

TEST_P(AllHits, AreInOrder) {
    for (size_t i = 1; i < expected_.offsets.size(); ++i) {
        const auto begin = expected_.hits.begin();
        EXPECT_TRUE(std::is_sorted(begin + ptrdiff_t(expected_.offsets[i - 1]),
                                   begin + ptrdiff_t(expected_.offsets[i]), comes_before))
            << "of ray " << i - 1;
    }
}

TEST_P(AllHits, AreThoseOfBruteForce) {
    for (TraceOptions way : test::all_ways())
        for (const size_t budget : {size_t{0}, size_t{RSH_MIN_BUDGET}}) {
            SCOPED_TRACE(name_of(way) + ", budget " + std::to_string(budget));
            way.budget = budget;
            way.own_scratch = budget != 0;
            way.own_bounds = budget != 0;
            way.converging = budget != 0;
            const HitLists lists = hit_lists(mesh_, case_.rays, expected_.offsets.back(), way);
            EXPECT_TRUE(test::same_bits(lists.offsets, expected_.offsets, "offsets"));
            EXPECT_TRUE(test::same_bits(lists.hits, expected_.hits, "hits"));
        }
}

TEST_P(AllHits, AreCounted) {
    for (const TraceOptions& way : test::brute_force_and_all_ways()) {
        SCOPED_TRACE(name_of(way));
        EXPECT_TRUE(test::same_bits(hit_counts(mesh_, case_.rays, way), counts_of(expected_),
                                    "counts"));
    }
}

TEST_P(AllHits, StayAwayWhereTheyDoNotFit) {
    const uint64_t all = expected_.offsets.back();
    if (all < 2) return;
    for (const TraceOptions& way : test::brute_force_and_all_ways())
        for (const uint64_t capacity : {uint64_t{1}, all - 1}) {
            SCOPED_TRACE(name_of(way) + ", room for " + std::to_string(capacity));
            const HitLists lists = hit_lists(mesh_, case_.rays, capacity, way);
            EXPECT_TRUE(test::same_bits(lists.offsets, expected_.offsets, "offsets"));
            EXPECT_TRUE(
                test::same_bits(lists.hits, test::Buffer<rsh_hit>(capacity).read(), "hits"));
        }
}

// Every width is a program of its own.
TEST(AllHitsOfASoup, AreTheSameWithEveryVectorWidth) {
    test::Random random(52);
    const DeviceMesh mesh(test::random_soup(random, test::small() ? 50 : 700));
    const test::Rays rays = test::random_rays(random, test::small() ? 8 : 48, 31);
    const HitLists expected = all_hits(mesh, rays, test::brute_force());
    for (const cl_uint width : {1u, 4u, 8u, 16u})
        for (TraceOptions way : test::brute_force_and_all_ways()) {
            SCOPED_TRACE(name_of(way) + ", width " + std::to_string(width));
            const test::OwnContext context(width);
            way.context = context.get();
            const HitLists lists = hit_lists(mesh, rays, expected.offsets.back(), way);
            EXPECT_TRUE(test::same_bits(lists.offsets, expected.offsets, "offsets"));
            EXPECT_TRUE(test::same_bits(lists.hits, expected.hits, "hits"));
        }
}

TEST(AllHitsOfASoup, AreTheSameWhereTestsAreCounted) {
    test::Random random(54);
    const DeviceMesh mesh(test::random_soup(random, test::small() ? 50 : 700));
    const test::Rays rays = test::random_rays(random, 31, 17);
    const auto expected = hit_counts(mesh, rays, test::brute_force());
    const size_t count = rays.rays.size();
    for (const cl_uint engine : {RSH_ENGINE_TILES, RSH_ENGINE_BRUTE_FORCE}) {
        const test::Buffer<uint32_t> tests(std::vector<uint32_t>(count, 0));
        TraceOptions options;
        options.engine = engine;
        options.tests_per_ray = tests.get();
        EXPECT_TRUE(test::same_bits(hit_counts(mesh, rays, options), expected, "counts"));
        const auto counted = tests.read();
        for (size_t i = 0; i < count; ++i) ASSERT_GE(counted[i], expected[i]) << i;
    }
}

// More hits than are sorted by insertion, for one ray.
TEST(AllHitsOfALine, AreInOrder) {
    test::Mesh mesh;
    const uint32_t layers = test::small() ? 100 : 3000;
    for (uint32_t i = 0; i < layers; ++i) {
        const float z = float(i * 7919 % layers / 2);  // each depth twice
        for (const test::Float3& corner : {test::Float3{-1, -1, z}, {1, -1, z}, {0, 2, z}})
            mesh.vertices.push_back(corner);
    }
    const test::Rays rays = test::pinhole_rays(1, 1, {0, 0, -1}, {0, 0, 1});
    for (const TraceOptions& way : test::brute_force_and_all_ways()) {
        SCOPED_TRACE(name_of(way));
        const HitLists lists = all_hits(DeviceMesh(mesh), rays, way);
        ASSERT_EQ(lists.hits.size(), layers);
        EXPECT_TRUE(std::is_sorted(lists.hits.begin(), lists.hits.end(), comes_before));
    }
}

// As many hits as a tile keeps of a ray, fewer and more, side by side. Room for so many that lists are
// stored past the caches.
TEST(AllHitsOfManyLayers, AreThoseOfBruteForce) {
    test::Random random(55);
    const DeviceMesh mesh(test::random_soup(random, test::small() ? 80 : 150, 0.8f));
    const test::Rays rays = test::pinhole_rays(test::small() ? 19 : 71, 35);
    const HitLists expected = all_hits(mesh, rays, test::brute_force());
    const auto counts = counts_of(expected);
    for (const uint32_t count : {RSH_HIT_ROWS - 1, RSH_HIT_ROWS, RSH_HIT_ROWS + 1})
        ASSERT_GT(std::count(counts.begin(), counts.end(), count), 0) << "rays of " << count;
    for (const TraceOptions& way : test::all_ways())
        for (const uint64_t capacity : {expected.offsets.back(), uint64_t{RSH_LARGE_LIST}}) {
            SCOPED_TRACE(name_of(way) + ", room for " + std::to_string(capacity));
            HitLists lists = hit_lists(mesh, rays, capacity, way);
            lists.hits.resize(expected.hits.size());
            EXPECT_TRUE(test::same_bits(lists.offsets, expected.offsets, "offsets"));
            EXPECT_TRUE(test::same_bits(lists.hits, expected.hits, "hits"));
        }
}

// Rays that there are not have no hits, and their counts stay as they were.
TEST(AllHitsOfAList, AreOfTheRaysThatThereAre) {
    test::Random random(53);
    const DeviceMesh mesh(test::random_soup(random, test::small() ? 50 : 400, 0.5f));
    const test::Rays rays = test::random_rays(random, 700, 1);
    const uint32_t count = 301, untouched = 77;
    const auto all = counts_of(all_hits(mesh, rays, test::brute_force()));
    for (TraceOptions way : test::brute_force_and_all_ways()) {
        SCOPED_TRACE(name_of(way));
        way.list_count = count;
        auto expected = all;
        std::fill(expected.begin() + count, expected.end(), untouched);
        EXPECT_TRUE(
            test::same_bits(hit_counts(mesh, rays, way, untouched), expected, "counts"));
        std::fill(expected.begin() + count, expected.end(), 0);
        EXPECT_TRUE(test::same_bits(counts_of(all_hits(mesh, rays, way)), expected, "listed"));
    }
}

INSTANTIATE_TEST_SUITE_P(All, AllHits, ::testing::ValuesIn(test::all_cases()), test::case_name);

}  // namespace
