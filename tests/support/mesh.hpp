// mesh.hpp - triangles on the host, and the meshes that tests make from code.
// Generators draw from a Random, so the seed decides; none of them avoids degenerate input.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "support/random.hpp"
#include "support/vec.hpp"

namespace test {

using Corners = std::array<Float3, 3>;

struct Mesh {
    std::vector<Float3> vertices;
    std::vector<uint32_t> indices;  // empty: triangle i has the vertices 3i, 3i + 1, 3i + 2

    uint32_t triangle_count() const;
    // Index out of range: false, and the corners are not to be used.
    bool corners(uint32_t triangle, Corners* out) const;
    void add(Float3 a, Float3 b, Float3 c);  // triangle soup only
};

// `count` triangles with corners within `size` of a point of the cube of half-width 1.
Mesh random_soup(Random& random, uint32_t count, float size = 0.3f);

// Closed, indexed, every edge shared by two triangles: 2 * rings * (segments - 1) triangles ...
Mesh sphere(uint32_t segments, uint32_t rings, float radius = 1.0f);
// ... and 2 * rings * segments.
Mesh torus(uint32_t segments, uint32_t rings, float radius = 1.0f, float tube = 0.4f);

// The triangles between rings of vertices, the last ring beside the first.
void add_closed_lattice(Mesh& mesh, uint32_t segments, uint32_t rings);

// A square grid of 2 * n * n triangles in the plane z = 0 over [-1, 1]^2, on exact coordinates.
Mesh grid(uint32_t n);

Mesh scaled(Mesh mesh, float scale, Float3 offset = {});

// Zero area, duplicates, needles, slivers, NaN and infinite vertices, an index out of range.
Mesh degenerate_soup(Random& random, uint32_t count);

// Right-angled, along the axes, so that corners of triangles are corners of boxes.
Mesh square_triangles(Random& random, uint32_t count);
// So many, each one of `once`, its corners as they were, turned or reversed.
Mesh turned_copies(Random& random, const Mesh& once, uint32_t count);

// One triangle around everything and many below 1e-4.
Mesh large_next_to_tiny(Random& random, uint32_t count);

}  // namespace test
