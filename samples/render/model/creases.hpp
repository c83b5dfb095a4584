// creases.hpp - cuts a mesh open along its sharp edges, so that smooth normals end there.
#pragma once

#include "model/model.hpp"

namespace render {

struct CreasedMesh {
    Mesh mesh;
    std::vector<uint32_t> source;  // the vertex of the uncut mesh that each vertex copies
};

// Copies the vertices at edges whose triangles meet at more than `degrees`; the triangles keep
// their order. Triangles at an edge that three share, or that their neighbour passes in the same
// direction, get vertices of their own.
CreasedMesh split_at_creases(const Mesh& mesh, float degrees);

}  // namespace render
