// scene_bvh_test.cpp - the tree leaves out work and no hit: brute force by the same routine has the same
// bits; and that routine agrees with the oracle that bounds rounding.
#include "oracle/frame/scene_bvh.hpp"

#include <gtest/gtest.h>

#include "oracle/accepts.hpp"

namespace {

using oracle::Hit;
using oracle::Ray;

Hit brute_force(const test::Mesh& mesh, const Ray& ray) {
    Hit best;
    best.t = ray.tmax;
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        test::Corners c;
        if (i == ray.skip || !mesh.corners(i, &c)) continue;
        const test::Double3 corner[3] = {test::Double3(c[0]), test::Double3(c[1]),
                                         test::Double3(c[2])};
        Hit hit;
        if (!oracle::intersect(ray, corner, &hit)) continue;
        if (best.primitive != RSH_NO_HIT && hit.t >= best.t) continue;
        best = hit;
        best.primitive = i;
    }
    return best;
}

void expect_brute_force(const test::Mesh& mesh, const std::vector<rsh_ray>& rays) {
    const oracle::SceneBvh bvh(mesh);
    for (size_t i = 0; i < rays.size(); ++i) {
        if (!test::is_active(rays[i])) continue;
        Ray ray(rays[i]);
        ray.skip = uint32_t(i) % 3 ? RSH_NO_HIT : brute_force(mesh, ray).primitive;
        const Hit expected = brute_force(mesh, ray), found = bvh.closest(ray);
        ASSERT_EQ(found.primitive, expected.primitive) << "ray " << i;
        ASSERT_EQ(found.t, expected.t) << "ray " << i;
        ASSERT_EQ(found.u, expected.u) << "ray " << i;
        ASSERT_EQ(found.v, expected.v) << "ray " << i;
        ASSERT_EQ(bvh.is_hit(ray), expected.primitive != RSH_NO_HIT) << "ray " << i;
    }
}

TEST(SceneBvh, FindsWhatBruteForceFinds) {
    test::Random random(1);
    const test::Mesh soup = test::random_soup(random, 500);
    expect_brute_force(soup, test::random_rays(random, 40, 40).rays);
    expect_brute_force(test::torus(24, 12), test::pinhole_rays(40, 40).rays);
    expect_brute_force(test::turned_copies(random, soup, 900), test::pinhole_rays(20, 20).rays);
}

// Boxes without height, rays in their planes and through edges and corners.
TEST(SceneBvh, FindsWhatBruteForceFindsAlongTheAxes) {
    test::Random random(2);
    expect_brute_force(test::grid(8), test::axis_rays(random, 30, 30).rays);
    expect_brute_force(test::square_triangles(random, 300),
                       test::axis_rays(random, 30, 30).rays);
}

TEST(SceneBvh, OfNothingHasNoHit) {
    const oracle::SceneBvh none{test::Mesh()};
    EXPECT_EQ(none.closest(Ray({0, 0, 0}, {0, 0, 1})).primitive, RSH_NO_HIT);
    EXPECT_FALSE(none.is_hit(Ray({0, 0, 0}, {0, 0, 1})));
}

TEST(SceneBvh, IsRightByTheOracleThatBoundsRounding) {
    const test::Mesh mesh = test::sphere(32, 15);
    const std::vector<rsh_ray> rays = test::pinhole_rays(64, 64).rays;
    const oracle::SceneBvh bvh(mesh);
    std::vector<rsh_hit> hits;
    for (const rsh_ray& ray : rays) {
        const Hit hit = bvh.closest(ray);
        hits.push_back({float(hit.t), float(hit.u), float(hit.v), hit.primitive});
    }
    EXPECT_TRUE(oracle::hits_are_correct(oracle::closest(mesh, rays), mesh, rays, hits));
}

}  // namespace
