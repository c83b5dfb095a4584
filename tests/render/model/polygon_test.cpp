// polygon_test.cpp - triangulation against the polygon's own area, and its count.
#include "model/polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace render {
namespace {

double signed_area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

// A star with 2n corners in the plane z = x + y, which faces upwards.
std::vector<glm::vec3> star(int points) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = 3.14159265358979 * i / points, radius = i % 2 == 0 ? 1.0 : 0.3;
        const double x = radius * std::cos(angle), y = radius * std::sin(angle);
        corners.emplace_back(x, y, x + y);
    }
    return corners;
}

// Positive areas that add up to the polygon's: no triangle is flipped, none overlaps.
TEST(Triangulate, CoversAConcavePolygonOnce) {
    for (const int points : {3, 5, 17, 100}) {
        const std::vector<glm::vec3> corners = star(points);
        double area = 0.0, expected = 0.0;
        for (size_t i = 0; i < corners.size(); ++i)
            expected += signed_area({0, 0}, glm::vec2(corners[i]),
                                    glm::vec2(corners[(i + 1) % corners.size()]));
        const auto triangles = triangulate(corners);
        EXPECT_EQ(triangles.size(), corners.size() - 2) << points << " points";
        for (const glm::uvec3 t : triangles) {
            const double part = signed_area(glm::vec2(corners[t.x]), glm::vec2(corners[t.y]),
                                            glm::vec2(corners[t.z]));
            EXPECT_GT(part, 0.0) << points << " points, triangle " << t.x << " " << t.y;
            area += part;
        }
        EXPECT_NEAR(area, expected, 1e-6) << points << " points";
    }
}

TEST(Triangulate, AlwaysYieldsTwoTrianglesLessThanCorners) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const size_t count : {0u, 1u, 2u, 3u, 4u, 7u, 2001u})
        for (const glm::vec3 corner : {glm::vec3(1.0f), glm::vec3(nan), glm::vec3(1e38f)})
            EXPECT_EQ(triangulate(std::vector<glm::vec3>(count, corner)).size(),
                      count < 3 ? 0 : count - 2)
                << count << " corners at " << corner.x;
}

}  // namespace
}  // namespace render
