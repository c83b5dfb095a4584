// lattice_test.cpp - the integers' judge judged, by what can be seen and by the other oracle.
#include "oracle/lattice.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

using oracle::Fault;
using test::Float3;

test::Mesh two_layers() {
    test::Mesh mesh;
    mesh.add({0, 0, 1}, {4, 0, 1}, {0, 4, 1});
    mesh.add({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    mesh.add({4, 0, 1}, {0, 0, 1}, {4, -4, 1});
    return mesh;
}

oracle::Answer answer(const rsh_ray& ray) {
    return oracle::lattice_closest(two_layers(), {ray})[0];
}

TEST(OracleLattice, FindsTheNearestAndOfEqualTheLowest) {
    EXPECT_EQ(answer(test::make_ray({1, 1, 4}, {0, 0, -1})).primitive, 0u);
    EXPECT_EQ(answer(test::make_ray({1, 1, 4}, {0, 0, -1})).t, 3);
    EXPECT_EQ(answer(test::make_ray({1, 1, -4}, {0, 0, 2})).primitive, 1u);
    EXPECT_EQ(answer(test::make_ray({2, 0, 4}, {0, 0, -1})).primitive, 0u);  // a shared edge
    EXPECT_EQ(answer(test::make_ray({3, -1, 4}, {0, 0, -1})).primitive, 2u);
    EXPECT_EQ(answer(test::make_ray({3, 2, 4}, {0, 0, -1})).primitive, RSH_NO_HIT);
    EXPECT_EQ(answer(test::make_ray({2, 2, 4}, {0, 0, -1})).primitive, 0u);          // an edge
    EXPECT_EQ(answer(test::make_ray({9, 1, 1}, {-1, 0, 0})).primitive, RSH_NO_HIT);  // edge-on
}

TEST(OracleLattice, KnowsTheEndsOfTheRayToTheLastBit) {
    const Float3 o(1, 1, 4), d(0, 0, -1);
    EXPECT_EQ(answer(test::make_ray(o, d, 0, 3)).primitive, 0u);
    EXPECT_EQ(answer(test::make_ray(o, d, 3, 3)).primitive, 0u);
    EXPECT_EQ(answer(test::make_ray(o, d, std::nextafter(3.0f, 4.0f))).primitive, 1u);
    EXPECT_EQ(answer(test::make_ray(o, d, 0, std::nextafter(3.0f, 0.0f))).primitive,
              RSH_NO_HIT);
}

TEST(OracleLattice, AgreesWithTheOtherOracle) {
    test::Random random(21);
    test::Mesh mesh;
    const auto point = [&](int half) {
        const auto one = [&] {
            return float(int(random.below(uint32_t(2 * half + 1))) - half);
        };
        return Float3(one(), one(), one());
    };
    for (int i = 0; i < 200; ++i) mesh.add(point(40), point(40), point(40));
    std::vector<rsh_ray> rays;
    for (int i = 0; i < 500; ++i) rays.push_back(test::make_ray(point(60), point(16)));
    const auto exact = oracle::lattice_closest(mesh, rays), other = oracle::closest(mesh, rays);
    for (size_t i = 0; i < rays.size(); ++i) {
        if (other[i].ambiguous) continue;
        ASSERT_EQ(exact[i].primitive, other[i].primitive) << "ray " << i;
        ASSERT_NEAR(exact[i].t, other[i].t, 1e-12) << "ray " << i;
    }
}

TEST(OracleLattice, JudgesEveryBit) {
    const test::Mesh mesh = two_layers();
    const rsh_ray ray = test::make_ray({2, 0, 4}, {0, 0, -1});
    const auto fault = [&](const rsh_hit& hit) {
        return oracle::judge_exact(answer(ray), mesh, ray, hit).fault;
    };
    EXPECT_EQ(fault({3, 0.5f, 0, 0}), Fault::kNone);
    EXPECT_EQ(fault({3, 0.5f, 0, 2}), Fault::kWrongTriangle);
    EXPECT_EQ(fault({4, 0.5f, 0, 1}), Fault::kMissed);
    EXPECT_EQ(fault({INFINITY, 0, 0, RSH_NO_HIT}), Fault::kMissed);
    EXPECT_EQ(fault({std::nextafter(3.0f, 0.0f), 0.5f, 0, 0}), Fault::kSpurious);
    EXPECT_EQ(fault({NAN, 0.5f, 0, 0}), Fault::kSpurious);
    EXPECT_EQ(fault({3, 0.25f, 0, 0}), Fault::kSpurious);
    const rsh_ray beside = test::make_ray({9, 9, 4}, {0, 0, -1});
    EXPECT_EQ(oracle::judge_exact(answer(beside), mesh, beside, {3, 0, 0, 0}).fault,
              Fault::kSpurious);
}

TEST(OracleLattice, RefusesWhatIsNoSmallInteger) {
    EXPECT_THROW(answer(test::make_ray({0.5f, 1, 4}, {0, 0, -1})), std::invalid_argument);
    EXPECT_THROW(answer(test::make_ray({129, 1, 4}, {0, 0, -1})), std::invalid_argument);
    EXPECT_THROW(answer(test::make_ray({1, 1, 4}, {0, 0, -17})), std::invalid_argument);
}

}  // namespace
