// lattice_numbers.hpp - corners, origins and directions as integers, and t as a quotient of two: what
// the oracles of lattices calculate with.
//
// With the limits of lattice.hpp a component of a corner seen from an origin is below 2^9, one of a
// normal below 2^19, and both terms of t below 2^30 and 2^25, so that fractions are compared within
// 2^55.
#pragma once

#include <vector>

#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace oracle {

using Int3 = test::Vec3<int64_t>;

// numerator / denominator, the latter positive.
struct Fraction {
    int64_t numerator, denominator;
};

bool is_less(Fraction a, Fraction b);
// Below 0, 0 or above it.
int compared(Fraction t, float limit);

struct LatticeTriangle {
    uint32_t number;
    Int3 corner[3];
    Int3 normal;
};

// The valid ones. These throw std::invalid_argument at what is no integer, or too large.
std::vector<LatticeTriangle> lattice_triangles(const test::Mesh& mesh);
Int3 lattice_origin(const rsh_ray& ray);
Int3 lattice_direction(const rsh_ray& ray);

// Where the line meets the triangle's plane, which it is not parallel to.
Fraction lattice_t(const LatticeTriangle& triangle, Int3 origin, Int3 direction);

}  // namespace oracle
