// filter.hpp - which of a run of triangles can a ray meet at all: the inner loop of the oracle,
// written for the vectorizer. Decides nothing; what it lets pass goes to oracle::intersect.
#pragma once

#include <cstdint>
#include <vector>

#include <rsh/rsh_types.h>

#include "support/mesh.hpp"

namespace oracle {

constexpr uint32_t kBlock = 512;

// Up to kBlock valid triangles, component by component, relative to nothing; `reach` is the
// largest coordinate difference of a corner from `centre`.
struct Block {
    test::Double3 centre;
    uint32_t count = 0;
    double corner[9][kBlock];
    double reach[kBlock];
    uint32_t triangle[kBlock];
};

std::vector<Block> make_blocks(const test::Mesh& mesh);

// Appends the triangles of `block` that are within rounding of the line of the ray.
void filter(const Block& block, const rsh_ray& ray, std::vector<uint32_t>* out);

}  // namespace oracle
