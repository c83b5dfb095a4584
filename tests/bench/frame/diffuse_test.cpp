#include "frame/diffuse.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bench {
namespace {

// A triangle in the plane z = 1, seen from below by rays along +z.
const std::vector<glm::vec3> kPositions = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
const std::vector<glm::uvec3> kTriangles = {{0, 1, 2}};

std::vector<rsh_ray> diffuse(size_t count, size_t missing) {
    std::vector<rsh_ray> rays(count, rsh_ray{{{0.25f, 0.25f, 0, 0}}, {{0, 0, 1, INFINITY}}});
    std::vector<rsh_hit> hits(count, rsh_hit{1, 0.25f, 0.25f, 0});
    hits.at(missing).primitive = RSH_NO_HIT;
    make_diffuse(kPositions, kTriangles, hits, rays);
    return rays;
}

TEST(Diffuse, LeavesTheSideThatTheRayCameFromWithTheCosinesDistribution) {
    const auto rays = diffuse(20000, 0);
    double sum = 0;
    for (size_t i = 1; i < rays.size(); ++i) {
        const cl_float* d = rays[i].direction_tmax.s;
        ASSERT_LT(rays[i].origin_tmin.s[2], 1.0f) << "ray " << i;
        ASSERT_LE(d[2], 0.0f) << "ray " << i;
        ASSERT_NEAR(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1.0, 1e-5) << "ray " << i;
        sum -= d[2];
    }
    // The mean of cos with density cos / pi over the hemisphere is 2/3; its deviation over
    // 20000 rays is 0.0017.
    EXPECT_NEAR(sum / double(rays.size() - 1), 2.0 / 3.0, 0.008);
}

TEST(Diffuse, IsInactiveWhereNothingWasHit) {
    EXPECT_LT(diffuse(10, 4)[4].direction_tmax.s[3], 0.0f);
}

TEST(Diffuse, HasNothingInCommonWithItsNeighbour) {
    const auto rays = diffuse(2000, 0);
    double sum = 0;
    for (size_t i = 2; i < rays.size(); ++i)
        sum += rays[i].direction_tmax.s[0] * rays[i - 1].direction_tmax.s[0];
    // Independent: 0 with deviation 0.25 / sqrt(2000).
    EXPECT_NEAR(sum / double(rays.size()), 0.0, 0.03);
}

}  // namespace
}  // namespace bench
