#include "paper/cones/cone.hpp"

#include <gtest/gtest.h>

#include <random>

#include "paper/cones/false_positives.hpp"

namespace bench::paper {
namespace {

class Random {
public:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(generator_);
    }
    glm::dvec3 point(double size) {
        return {between(-size, size), between(-size, size), between(-size, size)};
    }

private:
    std::mt19937 generator_{1};
};

rsh_ray make_ray(glm::dvec3 o, glm::dvec3 d) {
    return {{{float(o.x), float(o.y), float(o.z), 0}},
            {{float(d.x), float(d.y), float(d.z), 1e30f}}};
}

TEST(PaperCone, OfOneRayMeetsWhatLiesOnIt) {
    const Cone cone = cone_of(make_ray({0, 0, 0}, {0, 0, 2}));
    EXPECT_TRUE(meets(cone, Triangle{{-1, -1, 3}, {1, -1, 3}, {0, 2, 3}}));
    EXPECT_FALSE(meets(cone, Triangle{{0.5, -1, 3}, {2, -1, 3}, {2, 2, 3}}));
    EXPECT_FALSE(meets(cone, Triangle{{-1, -1, -3}, {1, -1, -3}, {0, 2, -3}}));
}

// A triangle beside a wide cone, whose sphere reaches into it.
TEST(PaperCone, SphereMeetsWhereItsTriangleDoesNot) {
    Cone cone = cone_of(make_ray({0, 0, 0}, {0, 0, 1}));
    cone.angle = 0.5;
    const Triangle triangle = {{3.0, -2, 4}, {3.0, 2, 4}, {3.0, 0, 5}};
    EXPECT_TRUE(meets(cone, sphere_of(triangle)));
    EXPECT_FALSE(meets(cone, triangle));
}

TEST(PaperCone, SphereOfATriangleHoldsItsCorners) {
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const Triangle triangle = {random.point(1), random.point(1), random.point(1)};
        const Sphere sphere = sphere_of(triangle);
        for (const glm::dvec3& corner : triangle)
            EXPECT_LE(glm::distance(sphere.centre, corner), sphere.radius * (1 + 1e-9));
    }
}

// Wherever a ray of the cone meets a triangle, the cone does, and so does the triangle's sphere.
TEST(PaperCone, MergedMeetsWhatItsRaysMeet) {
    Random random;
    for (int i = 0; i < 2000; ++i) {
        std::vector<Cone> rays;
        glm::dvec3 met{0.0};
        for (int ray = 0; ray < 4; ++ray) {
            const glm::dvec3 origin = random.point(0.2);
            const glm::dvec3 way = glm::dvec3(0, 0, 1) + random.point(0.4);
            rays.push_back(cone_of(make_ray(origin, way)));
            met = rays.back().apex + random.between(0, 4) * rays.back().axis;
        }
        const Cone cone = merge(rays);
        const glm::dvec3 u = random.point(0.5), v = random.point(0.5);
        const Triangle triangle = {met + u, met + v, met - u - v};  // its centroid is `met`
        EXPECT_TRUE(meets(cone, triangle));
        EXPECT_TRUE(meets(cone, sphere_of(triangle)));
    }
}

// By a grid of points of the triangle.
TEST(PaperCone, MeetsATriangleIfItMeetsOneOfItsPoints) {
    Random random;
    int missed = 0, met = 0;
    for (int i = 0; i < 300; ++i) {
        Cone cone = cone_of(make_ray(random.point(1), random.point(1)));
        cone.angle = random.between(0, 1.2);
        cone.radius = random.between(0, 0.5);
        const Triangle t = {random.point(4), random.point(4), random.point(4)};
        // No point of a triangle is farther than that from one of the grid.
        constexpr double kGap = 0.3;
        Cone wider = cone;
        wider.radius += kGap;
        bool is_near = false, is_rather_near = false;
        constexpr int kSteps = 60;
        for (int a = 0; a <= kSteps; ++a)
            for (int b = 0; a + b <= kSteps; ++b) {
                const double u = double(a) / kSteps, v = double(b) / kSteps;
                const Sphere point = {(1 - u - v) * t[0] + u * t[1] + v * t[2], 0};
                is_near |= meets(cone, point);
                is_rather_near |= meets(wider, point);
            }
        (meets(cone, t) ? met : missed) += 1;
        EXPECT_TRUE(!is_near || meets(cone, t)) << i;
        EXPECT_TRUE(!meets(cone, t) || is_rather_near) << i;
    }
    EXPECT_GT(missed, 20);
    EXPECT_GT(met, 20);
}

TEST(PaperCone, DescentsLoseNoRayThatMeetsATriangle) {
    std::vector<rsh_ray> rays;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            rays.push_back(make_ray({0, 0, 0}, {0.1 * (x - 7.5), 0.1 * (y - 7.5), 1}));
    ConeTests tests;
    descend(make_pyramid(rays, 16), {{-0.5, -0.5, 2}, {0.5, -0.5, 2}, {0, 0.5, 2}}, tests);
    EXPECT_EQ(tests.missed, 0u);
    EXPECT_GT(tests.rays_by_triangle, 0u);
    EXPECT_GE(tests.rays_by_sphere, tests.rays_by_triangle);
    EXPECT_GE(tests.by_sphere, tests.by_triangle);
}

}  // namespace
}  // namespace bench::paper
