// aff_shapes.hpp - the curved primitives of AFF as triangles.
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace render {

// Triangles over smooth vertices; normals are unit and point outwards.
struct Shape {
    std::vector<glm::dvec3> positions, normals;
    std::vector<glm::uvec3> triangles;
};

// Around a cone, and around a sphere's equator.
constexpr uint32_t kSides = 24;

// An open cone (or cylinder) of kSides quads, each two triangles.
Shape make_cone(glm::dvec3 base, double base_radius, glm::dvec3 apex, double apex_radius);

// Of kSides / 2 bands from pole to pole.
Shape make_sphere(glm::dvec3 centre, double radius);

}  // namespace render
