// polygon_test.cpp - triangulation against the polygon's own area, and in time.
#include "model/polygon.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <random>

namespace render {
namespace {

using Corners = std::vector<glm::dvec3>;

double signed_area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

// In the plane z = x + y, which faces upwards.
void add(Corners& corners, double x, double y) {
    corners.emplace_back(x, y, x + y);
}

void add_polar(Corners& corners, double radius, double angle) {
    add(corners, radius * std::cos(angle), radius * std::sin(angle));
}

// Each has `count` corners, an even number.
Corners circle(int count) {
    Corners corners;
    for (int i = 0; i < count; ++i) add_polar(corners, 1.0, 6.28318530717958 * i / count);
    return corners;
}

Corners star(int count) {
    Corners corners;
    for (int i = 0; i < count; ++i)
        add_polar(corners, i % 2 == 0 ? 1.0 : 0.3, 6.28318530717958 * i / count);
    return corners;
}

Corners rough_star(int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> radius(0.01, 1.0);
    Corners corners;
    for (int i = 0; i < count; ++i)
        add_polar(corners, radius(random), 6.28318530717958 * i / count);
    return corners;
}

Corners comb(int count) {
    Corners corners{{0, -1, -1}};
    add(corners, count, -1);
    for (int i = count - 3; i >= 0; --i) add(corners, i + 0.5, i % 2 == 0 ? 0.0 : 1.0);
    return corners;
}

// Teeth on both sides of a band that is bent: the backs are concave.
Corners bent_comb(int count) {
    Corners corners;
    const int half = count / 2;
    for (int i = 0; i < half; ++i) add_polar(corners, 1.0 + (i % 2) * 0.5, 5.0 * i / half);
    for (int i = half - 1; i >= 0; --i) add_polar(corners, 0.9, 5.0 * (i + 0.5) / half);
    return corners;
}

Corners spiral(int count) {
    Corners corners;
    const int half = count / 2;
    const double angle = std::min(120.0 / half, 0.2);
    for (int i = 0; i < half; ++i) add_polar(corners, 1.0 + 20.0 * i / half, angle * i);
    for (int i = half - 1; i >= 0; --i) add_polar(corners, 0.6 + 20.0 * i / half, angle * i);
    return corners;
}

Corners zigzag(int count) {
    Corners corners;
    const int half = count / 2;
    for (int i = 0; i < half; ++i) add(corners, i, i % 2);
    for (int i = half - 1; i >= 0; --i) add(corners, i, i % 2 + 0.01);
    return corners;
}

struct Shape {
    const char* name;
    Corners (*make)(int count);
};
constexpr Shape kShapes[] = {
    {"circle", circle},       {"star", star},     {"rough star", rough_star}, {"comb", comb},
    {"bent comb", bent_comb}, {"spiral", spiral}, {"zigzag", zigzag}};

// Positive areas that add up to the polygon's: no triangle is flipped, none overlaps.
void expect_covered_once(const Corners& corners, const std::string& what) {
    double area = 0.0, expected = 0.0;
    for (size_t i = 0; i < corners.size(); ++i)
        expected += signed_area({0, 0}, glm::dvec2(corners[i]),
                                glm::dvec2(corners[(i + 1) % corners.size()]));
    const auto triangles = triangulate(corners);
    EXPECT_EQ(triangles.size(), corners.size() - 2) << what;
    size_t flipped = 0;
    for (const glm::uvec3 t : triangles) {
        const double part = signed_area(glm::dvec2(corners[t.x]), glm::dvec2(corners[t.y]),
                                        glm::dvec2(corners[t.z]));
        flipped += part < 0.0;
        area += std::abs(part);
    }
    EXPECT_EQ(flipped, 0u) << what;
    EXPECT_NEAR(area, expected, 1e-9 * expected) << what;
}

TEST(Triangulate, CoversAPolygonOnce) {
    for (const Shape& shape : kShapes)
        for (const int count : {34, 200, 3000})
            expect_covered_once(shape.make(count),
                                shape.name + (" of " + std::to_string(count)));
}

// n log n: with a wide margin for a busy machine. Looking for each ear in all corners takes minutes.
TEST(Triangulate, HasTimeForManyCorners) {
    for (const Shape& shape : kShapes) {
        const Corners corners = shape.make(40000);
        const auto start = std::chrono::steady_clock::now();
        EXPECT_EQ(triangulate(corners).size(), corners.size() - 2);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        EXPECT_LT(seconds.count(), 10.0) << shape.name;
    }
}

// A face that repeats its corners is what broken exporters and hostile files have.
TEST(Triangulate, HasTimeForPolygonsThatCrossThemselves) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    Corners wild, repeated, doubled = star(50000);
    for (int i = 0; i < 50000; ++i) {
        add(wild, anywhere(random), anywhere(random));
        repeated.push_back(star(10)[static_cast<size_t>(i % 7 * i % 10)]);
    }
    doubled.insert(doubled.end(), doubled.rbegin(), doubled.rend() - 1);
    for (const Corners& corners : {wild, repeated, doubled}) {
        const auto start = std::chrono::steady_clock::now();
        EXPECT_EQ(triangulate(corners).size(), corners.size() - 2);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        EXPECT_LT(seconds.count(), 10.0) << "case " << &corners - &wild;
    }
}

// Corners of a small grid around a point that sees them all: many are in line.
TEST(Triangulate, CoversPolygonsOnAGridOnce) {
    std::mt19937 random(11);
    for (int round = 0; round < 300; ++round) {
        Corners corners;
        for (int x = -20; x <= 20; ++x)
            if (random() % 3 != 0) add(corners, x, -1.0 - random() % 3);
        add(corners, 100, 0);
        for (int x = 20; x >= -20; --x)
            if (random() % 3 != 0) add(corners, x, 1.0 + random() % 3);
        add(corners, -100, 0);
        expect_covered_once(corners, "round " + std::to_string(round));
    }
}

// A doubled edge leads from the outside to each hole and back.
TEST(Triangulate, CoversPolygonsWithHolesOnce) {
    Corners square;
    for (const double x : {0.0, 3.0, 6.0}) {
        add(square, x, 0);
        for (const auto& step : {glm::dvec2(0, 0), glm::dvec2(0, 2), glm::dvec2(2, 2),
                                 glm::dvec2(2, 0), glm::dvec2(0, 0)})
            add(square, x + 0.5 + step.x, 1.0 + step.y);
        add(square, x, 0);
    }
    for (const auto& corner : {glm::dvec2(9, 0), glm::dvec2(9, 9), glm::dvec2(0, 9)})
        add(square, corner.x, corner.y);
    expect_covered_once(square, "square with three holes");
    Corners ring = circle(5000);
    ring.push_back(Corners::value_type(ring[0]));
    const Corners inner = star(5000);
    for (int i = 5000; i >= 0; --i)
        add(ring, 0.9 * inner[static_cast<size_t>(i % 5000)].x,
            0.9 * inner[static_cast<size_t>(i % 5000)].y);
    expect_covered_once(ring, "ring");
}

TEST(Triangulate, AlwaysYieldsTwoTrianglesLessThanCorners) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const size_t count : {0u, 1u, 2u, 3u, 4u, 7u, 2001u})
        for (const double value : {1.0, nan, 1e38, 1e308}) {
            const Corners corners(count, glm::dvec3(value));
            EXPECT_EQ(triangulate(corners).size(), count < 3 ? 0 : count - 2)
                << count << " corners at " << value;
        }
    Corners huge;
    for (int i = 0; i < 9; ++i) huge.emplace_back(i % 2 * 1e200, i % 3 * 1e200, 0);
    EXPECT_EQ(triangulate(huge).size(), 7u);
}

}  // namespace
}  // namespace render
