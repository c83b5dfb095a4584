#include "stability/tally.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace {

using namespace bench::stability;

constexpr rsh_hit kHit = {2, 0.25f, 0.25f, 0};
constexpr rsh_hit kNoHit = {INFINITY, 0, 0, RSH_NO_HIT};

// The same triangle twice; one ray hits it, one does not.
Scene two_rays() {
    Scene scene;
    scene.mesh.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    scene.mesh.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    scene.rays = {
        {test::make_ray({0.25f, 0.25f, 2}, {0, 0, -1}), test::make_ray({2, 2, 2}, {0, 0, -1})},
        2,
        1};
    return scene;
}

Tally tally_of(const Scene& scene, const std::vector<rsh_hit>& hits,
               const std::vector<rsh_hit>& reference) {
    Tally tally;
    tally.add_hits(scene, expected_answers(scene, Kind::kRandom, 100), reference, hits);
    return tally;
}

// The only counter of faults that is not 0 is `key`, and the case is not good.
void expect_fault(const std::vector<rsh_hit>& hits, const char* key,
                  const Scene& scene = two_rays()) {
    const Tally tally = tally_of(scene, hits, hits);
    EXPECT_FALSE(tally.is_good(Kind::kRandom)) << key;
    for (const char* one :
         {"missed", "spurious", "wrong_triangle", "differ", "nan_out", "self_hits"})
        EXPECT_EQ(tally.metrics()[one].get<int>(), std::string(one) == key) << one;
}

TEST(Tally, CountsRaysPairsAndDecisions) {
    const Tally tally = tally_of(two_rays(), {kHit, kNoHit}, {kHit, kNoHit});
    EXPECT_TRUE(tally.is_good(Kind::kRandom)) << tally.metrics();
    const nlohmann::json metrics = tally.metrics();
    for (const auto& [key, count] : {std::pair("rays", 2),
                                     {"pairs", 4},
                                     {"decisions", 4},
                                     {"undecided", 0},
                                     {"missed", 0},
                                     {"self_hits", 0}})
        EXPECT_EQ(metrics[key].get<int>(), count) << key;
}

TEST(Tally, CountsEachFaultByItsName) {
    expect_fault({kNoHit, kNoHit}, "missed");
    expect_fault({kHit, {1, 0, 0, 0}}, "spurious");
    expect_fault({kHit, {7, 0, 0, RSH_NO_HIT}}, "spurious");
    expect_fault({{2, 0.25f, 0.25f, 1}, kNoHit}, "wrong_triangle");
}

TEST(Tally, CountsNaN) {
    const Tally tally = tally_of(two_rays(), {{2, NAN, 0.25f, 0}, kNoHit}, {kHit, kNoHit});
    EXPECT_EQ(tally.metrics()["nan_out"], 1);
    EXPECT_FALSE(tally.is_good(Kind::kRandom));
}

TEST(Tally, CountsWhatDiffersFromBruteForce) {
    rsh_hit other = kHit;
    other.u = std::nextafter(other.u, 1.0f);
    const Tally tally = tally_of(two_rays(), {other, kNoHit}, {kHit, kNoHit});
    EXPECT_EQ(tally.metrics()["differ"], 1);
    EXPECT_EQ(tally.metrics()["spurious"], 0);
    EXPECT_FALSE(tally.is_good(Kind::kRandom));
}

TEST(Tally, CountsHitsOfTheTriangleThatARayLeaves) {
    Scene scene = two_rays();
    scene.rays.skip = {0, RSH_NO_HIT};
    const Tally wrong = tally_of(scene, {kHit, kNoHit}, {kHit, kNoHit});
    EXPECT_EQ(wrong.metrics()["self_hits"], 1);
    EXPECT_FALSE(wrong.is_good(Kind::kAimed));
    const rsh_hit twin = {2, 0.25f, 0.25f, 1};
    EXPECT_TRUE(tally_of(scene, {twin, kNoHit}, {twin, kNoHit}).is_good(Kind::kAimed));
}

TEST(Tally, CountsOcclusion) {
    const Scene scene = two_rays();
    const Expected expected = expected_answers(scene, Kind::kRandom, 100);
    for (const cl_uint first : {0u, 1u})
        for (const cl_uint second : {0u, 1u}) {
            Tally tally;
            tally.add_occlusion(scene, expected, {kHit, kNoHit}, {first, second});
            EXPECT_EQ(tally.metrics()["missed"], 1 - first);
            EXPECT_EQ(tally.metrics()["spurious"], second);
            EXPECT_EQ(tally.metrics()["differ"], 1 - first + second);
            EXPECT_EQ(tally.is_good(Kind::kRandom), first == 1 && second == 0);
        }
}

// What lies on an edge may be hit or not, but not where rays are random.
TEST(Tally, AllowsUndecidedPairsWhereRaysAreAimed) {
    Scene scene = two_rays();
    scene.rays.rays[1] = test::make_ray({0.5f, 0, 2}, {0, 0, -1});
    const Tally tally = tally_of(scene, {kHit, kNoHit}, {kHit, kNoHit});
    EXPECT_EQ(tally.metrics()["undecided"], 2);
    EXPECT_TRUE(tally.is_good(Kind::kAimed));
    EXPECT_FALSE(tally.is_good(Kind::kRandom));
    EXPECT_FALSE(tally.is_good(Kind::kLattice));
}

TEST(Tally, TakesAMissInAClosedMeshForALeak) {
    const Scene scene = two_rays();
    const std::vector<rsh_hit> hits = {kHit, kNoHit};
    Tally tally;
    tally.add_hits(scene, expected_answers(scene, Kind::kClosed, 100), hits, hits);
    EXPECT_EQ(tally.metrics()["missed"], 1);
}

// Of the first ray both triangles, at one t; of the second none.
AllHits both_hits() {
    return {{0, 2, 2}, {kHit, {2, 0.25f, 0.25f, 1}}};
}

TEST(Tally, CountsWrongCounts) {
    const Scene scene = two_rays();
    const Expected expected = expected_answers(scene, Kind::kRandom, 100);
    for (const cl_uint first : {1u, 2u, 3u}) {
        Tally tally;
        tally.add_counts(scene, expected, both_hits(), {first, 0});
        EXPECT_EQ(tally.metrics()["missed"], int(first < 2));
        EXPECT_EQ(tally.metrics()["spurious"], int(first > 2));
        EXPECT_EQ(tally.metrics()["differ"], int(first != 2));
        EXPECT_EQ(tally.is_good(Kind::kRandom), first == 2);
    }
}

TEST(Tally, CountsWrongLists) {
    const Scene scene = two_rays();
    const Expected expected = expected_answers(scene, Kind::kRandom, 100);
    const auto metrics = [&](const AllHits& all) {
        Tally tally;
        tally.add_all(scene, expected, both_hits(), all);
        return tally.metrics();
    };
    EXPECT_EQ(metrics(both_hits())["differ"], 0);
    EXPECT_EQ(metrics(both_hits())["missed"], 0);
    const nlohmann::json missed = metrics({{0, 1, 1}, {kHit}});
    EXPECT_EQ(missed["missed"], 1);
    EXPECT_EQ(missed["differ"], 1);
    EXPECT_EQ(metrics({{0, 2, 2}, {{2, 0.25f, 0.25f, 1}, kHit}})["wrong_triangle"], 1);
    EXPECT_EQ(metrics({{0, 2, 3}, {kHit, {2, 0.25f, 0.25f, 1}, kHit}})["spurious"], 1);
    EXPECT_EQ(metrics({{0, 2, 2}, {kHit, {NAN, 0.25f, 0.25f, 1}}})["nan_out"], 1);
}

TEST(Tally, TakesAnOddCountThroughAClosedMeshForAFault) {
    const Scene scene = two_rays();
    const AllHits one = {{0, 1, 1}, {kHit}};
    for (const auto& [kind, count, key] :
         {std::tuple(Kind::kThrough, 1u, "spurious"), {Kind::kClosed, 2u, "missed"}}) {
        Tally tally;
        tally.add_counts(scene, expected_answers(scene, kind, 0), one, {count, count});
        EXPECT_GE(tally.metrics()[key].get<int>(), 1) << key;
    }
}

TEST(Tally, HashesAllRounds) {
    const std::vector<rsh_hit> hits = {kHit, kNoHit};
    const Scene scene = two_rays();
    const Expected expected = expected_answers(scene, Kind::kRandom, 100);
    Tally once, twice;
    once.add_hits(scene, expected, hits, hits);
    twice.add_hits(scene, expected, hits, hits);
    EXPECT_EQ(once.metrics()["hash"], twice.metrics()["hash"]);
    twice.add_hits(scene, expected, hits, hits);
    EXPECT_NE(once.metrics()["hash"], twice.metrics()["hash"]);
}

}  // namespace
