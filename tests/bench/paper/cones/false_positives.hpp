// false_positives.hpp - what the paper's spheres around triangles cost: descends a pyramid of cones with each
// triangle, once by its sphere, once by the triangle itself.
#pragma once

#include "paper/cones/cone.hpp"

namespace bench::paper {

struct ConeTests {
    size_t by_sphere = 0;        // (triangle, cone) tests of a descent by spheres
    size_t by_triangle = 0;      // of one by triangles
    size_t passed = 0;           // of `by_sphere`: the sphere meets the cone
    size_t false_positives = 0;  // of `passed`: the triangle does not
    size_t missed = 0;           // of what did not pass: the triangle meets the cone; must be 0
    size_t rays_by_sphere = 0;   // (triangle, ray) pairs that are left to be intersected
    size_t rays_by_triangle = 0;
};

// The levels of 2x2 nodes over a square screen, the rays first.
using Pyramid = std::vector<std::vector<Cone>>;
Pyramid make_pyramid(const std::vector<rsh_ray>& rays, size_t side);  // a power of two

void descend(const Pyramid& pyramid, const Triangle& triangle, ConeTests& tests);

// Nanoseconds of each test on this host, over cones of all levels that do not meet everything.
struct TestCosts {
    double sphere_ns = 0, triangle_ns = 0;
};
TestCosts time_tests(const Pyramid& pyramid, const std::vector<glm::dvec3>& corners);

}  // namespace bench::paper
