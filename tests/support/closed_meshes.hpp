// closed_meshes.hpp - closed surfaces that are hard to be inside of: knotted, on a lattice, spiky,
// with needles. A closed surface has for each edge of a triangle one that runs back.
#pragma once

#include "support/mesh.hpp"

namespace test {

// A tube along a trefoil knot, within 1 of the origin: 2 * rings * segments triangles.
Mesh trefoil(uint32_t segments, uint32_t rings);

// A cube from -half to half, all of whose faces are squares of side 1, cut along either diagonal:
// 48 * half^2 triangles, and every corner an integer.
Mesh lattice_box(Random& random, uint32_t half);

// A sphere whose vertices alternate between 1 and `inner` from its centre.
Mesh star(uint32_t segments, uint32_t rings, float inner);

// Splits an edge of so many of the triangles, and fills the slit to the neighbour with a triangle
// that has no area but what rounding gives it: a needle, or one with two equal corners.
Mesh with_needles(Random& random, Mesh mesh, uint32_t count);

// Holes are filled with fans; edges that run twice the same way stay as they are. Corners that are
// equal become one.
Mesh without_holes(const Mesh& mesh);

// Edges of triangles that no edge of another one runs back along.
uint32_t count_open_edges(const Mesh& mesh);

}  // namespace test
