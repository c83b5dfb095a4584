// crossings_test.cpp - the judges of counts and of all hits judged, by what can be seen and by each
// other.
#include "oracle/crossings/crossings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "oracle/crossings/judge_crossings.hpp"
#include "support/bodies.hpp"

namespace {

using oracle::Crossings;
using oracle::Fault;
using test::Float3;
using test::Mesh;

// A square of two triangles in z = 0, from (0, 0) to (4, 4), and two below it.
Mesh squares() {
    Mesh mesh;
    for (const float z : {0.0f, -2.0f}) {
        mesh.add({0, 0, z}, {4, 0, z}, {0, 4, z});
        mesh.add({4, 4, z}, {0, 4, z}, {4, 0, z});
    }
    return mesh;
}

std::vector<uint32_t> crossed(const Mesh& mesh, const rsh_ray& ray) {
    std::vector<uint32_t> triangles;
    const Crossings found = oracle::lattice_crossings(mesh, {ray})[0];
    for (const oracle::Crossing& c : found) {
        EXPECT_TRUE(c.is_certain);
        triangles.push_back(c.triangle);
    }
    return triangles;
}

using Numbers = std::vector<uint32_t>;

TEST(OracleCrossings, MoveThePointAlongXAndThenALittleAlongY) {
    const auto down = [](float x, float y) {
        return crossed(squares(), test::make_ray({x, y, 8}, {0, 0, -1}));
    };
    EXPECT_EQ(down(1, 1), (Numbers{0, 2}));  // within
    EXPECT_EQ(down(2, 2), (Numbers{1, 3}));  // on the diagonal
    EXPECT_EQ(down(0, 2), (Numbers{0, 2}));  // on the side that the point moves in from
    EXPECT_EQ(down(4, 2), Numbers{});        // on the one that it moves out of
    EXPECT_EQ(down(2, 0), (Numbers{0, 2}));  // along a side, and then inwards
    EXPECT_EQ(down(2, 4), Numbers{});        // along a side, and then outwards
    EXPECT_EQ(down(0, 0), (Numbers{0, 2}));
    EXPECT_EQ(down(0, 4), Numbers{});  // corners
    EXPECT_EQ(down(4, 0), Numbers{});
    EXPECT_EQ(down(4, 4), Numbers{});
    EXPECT_EQ(down(5, 1), Numbers{});
}

TEST(OracleCrossings, AreNotOfTrianglesSeenEdgeOn) {
    EXPECT_EQ(crossed(squares(), test::make_ray({-4, 1, 0}, {1, 0, 0})), Numbers{});
    EXPECT_EQ(crossed(squares(), test::make_ray({-4, 0, 0}, {1, 0, 0})), Numbers{});
}

TEST(OracleCrossings, KnowTheEndsOfTheRayAndWhatToSkip) {
    const rsh_ray whole = test::make_ray({1, 1, 8}, {0, 0, -1}, 8, 10);
    EXPECT_EQ(crossed(squares(), whole), (Numbers{0, 2}));
    EXPECT_EQ(crossed(squares(), test::make_ray({1, 1, 8}, {0, 0, -1}, 8, 9.5f)), Numbers{0});
    EXPECT_EQ(crossed(squares(), test::make_ray({1, 1, 8}, {0, 0, 1})), Numbers{});
    EXPECT_EQ(crossed(squares(), test::make_ray({1, 1, 0}, {0, 0, 1})), Numbers{0});
    const auto skipped = oracle::lattice_crossings(squares(), {whole}, {2});
    ASSERT_EQ(skipped[0].size(), 1u);
    EXPECT_EQ(skipped[0][0].triangle, 0u);
    EXPECT_EQ(skipped[0][0].t_low, 8);
    EXPECT_EQ(skipped[0][0].u, 0.25f);
}

TEST(OracleCrossings, OfALineAndABoxAreTwoOrNone) {
    const Mesh box = test::placed(test::box_body({4, 4, 4}), {});
    size_t two = 0, none = 0;
    for (int x = -6; x <= 6; ++x)
        for (int y = -6; y <= 6; ++y)
            for (const Float3 d : {Float3(0, 0, 1), Float3(1, 0, 1), Float3(2, -1, 4)}) {
                const Float3 at(float(x), float(y), 0);
                const size_t count = crossed(box, test::make_ray(at - 8.0f * d, d)).size();
                two += count == 2;
                none += count == 0;
            }
    EXPECT_EQ(two + none, 3u * 13 * 13);
    EXPECT_GE(std::min(two, none), 100u);
}

TEST(OracleCrossings, AgreeWithTheOtherOracle) {
    test::Random random(41);
    const auto point = [&](int half) {
        const auto one = [&] {
            return float(int(random.below(uint32_t(2 * half + 1))) - half);
        };
        return Float3(one(), one(), one());
    };
    Mesh mesh;
    for (int i = 0; i < 200; ++i) mesh.add(point(40), point(40), point(40));
    const auto part = [&] {
        return float(1u << random.below(4)) * (random.chance(0.5f) ? 1.0f : -1.0f);
    };
    std::vector<rsh_ray> rays;
    for (int i = 0; i < 500; ++i)
        rays.push_back(test::make_ray(point(60), {part(), part(), part()}));
    const auto exact = oracle::lattice_crossings(mesh, rays),
               other = oracle::crossings(mesh, rays);
    size_t found = 0, certain = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        Crossings both;
        for (const oracle::Crossing& c : exact[i])
            for (const oracle::Crossing& d : other[i])
                if (c.triangle == d.triangle) both.push_back(d);
        ASSERT_EQ(both.size(), exact[i].size())
            << "ray " << i << ": one is said to be impossible";
        for (size_t k = 0; k < both.size(); ++k) {
            const double t = 0.5 * (exact[i][k].t_low + exact[i][k].t_high);
            EXPECT_TRUE(t >= both[k].t_low && t <= both[k].t_high) << "ray " << i;
            EXPECT_NEAR(exact[i][k].u, both[k].u, both[k].uv_error) << "ray " << i;
        }
        found += exact[i].size();
        certain += other[i].size() - oracle::count_undecided(other[i]);
    }
    EXPECT_GT(found, 1000u);
    EXPECT_GT(certain, found * 9 / 10);
}

TEST(OracleCrossings, JudgeCounts) {
    const Crossings two_of_three = {
        {1, true, 1, 1, 0, 0, 1}, {4, false, 2, 3, 0, 0, 1}, {7, true, 2, 2, 0, 0, 1}};
    EXPECT_EQ(oracle::judge_count(two_of_three, 1).fault, Fault::kMissed);
    EXPECT_EQ(oracle::judge_count(two_of_three, 2).fault, Fault::kNone);
    EXPECT_EQ(oracle::judge_count(two_of_three, 3).fault, Fault::kNone);
    EXPECT_EQ(oracle::judge_count(two_of_three, 4).fault, Fault::kSpurious);
    EXPECT_EQ(oracle::count_undecided(two_of_three), 1u);
    EXPECT_EQ(oracle::judge_parity(3, true).fault, Fault::kNone);
    EXPECT_EQ(oracle::judge_parity(2, true).fault, Fault::kMissed);
    EXPECT_EQ(oracle::judge_parity(1, false).fault, Fault::kSpurious);
}

TEST(OracleCrossings, JudgeAllHits) {
    const Crossings expected = {{1, true, 1, 1, 0.5f, 0.25f, 0.1f},
                                {4, false, 1, 3, 0, 0, 1},
                                {7, true, 2, 2, 0, 0, 1}};
    const auto fault = [&](const std::vector<rsh_hit>& hits) {
        return oracle::judge_all(expected, hits.data(), hits.size()).fault;
    };
    const rsh_hit first = {1, 0.5f, 0.25f, 1}, second = {1, 0, 0, 4}, third = {2, 0, 0, 7};
    EXPECT_EQ(fault({first, second, third}), Fault::kNone);
    EXPECT_EQ(fault({first, third}), Fault::kNone);
    EXPECT_EQ(fault({first}), Fault::kMissed);
    EXPECT_EQ(fault({second, first, third}), Fault::kWrongTriangle);
    EXPECT_EQ(fault({first, first, third}), Fault::kSpurious);
    EXPECT_EQ(fault({first, {1, 0, 0, 3}, third}), Fault::kSpurious);
    EXPECT_EQ(fault({{1, 0.7f, 0.25f, 1}, third}), Fault::kSpurious);
    EXPECT_EQ(fault({first, {2.5f, 0, 0, 7}}), Fault::kSpurious);
    EXPECT_EQ(fault({first, {NAN, 0, 0, 7}}), Fault::kSpurious);
}

TEST(OracleCrossings, RefuseASlopeThatIsRounded) {
    EXPECT_THROW(crossed(squares(), test::make_ray({1, 1, 4}, {1, 0, 3})),
                 std::invalid_argument);
}

}  // namespace
