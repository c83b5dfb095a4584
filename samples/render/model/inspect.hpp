// inspect.hpp - what a mesh is as a surface: whether it has holes, and which side is outside.
// Vertices count as one where their positions are equal, whatever their normals and texture
// coordinates.
#pragma once

#include "model/model.hpp"

namespace render {

struct Inspection {
    size_t vertices = 0;  // different positions
    size_t triangles = 0;
    size_t components = 0;            // triangles that hang together by vertices
    size_t boundary_edges = 0;        // of one triangle
    size_t non_manifold_edges = 0;    // of three and more
    size_t flipped_edges = 0;         // whose triangles show different sides
    size_t degenerate_triangles = 0;  // without area, or not finite
    double volume = 0.0;              // behind the triangles' fronts; negative: in front
    bool is_closed = false;           // every edge has an even number of triangles
    bool is_wound_outwards = false;   // all fronts look away from what the mesh encloses
};

// Of an open mesh, the volume and the outside are those of the mesh with its holes closed by fans
// from one of its vertices.
Inspection inspect(const std::vector<glm::vec3>& positions,
                   const std::vector<glm::uvec3>& triangles);

// For each material that bends light: a warning when its triangles are not closed or not wound
// outwards, since a ray can then leave the glass without having entered it.
std::vector<std::string> glass_warnings(const Model& model);

}  // namespace render
