// windings.hpp - how often closed meshes wind around points: the sum of the solid angles of all
// triangles (Van Oosterom and Strackee, The Solid Angle of a Plane Triangle, 1983) over 4 pi, in
// double precision. Needs no ray, and so no rule for edges.
#pragma once

#include <vector>

#include "support/mesh.hpp"

namespace oracle {

struct Winding {
    int turns;   // 0: outside; 1: inside of one surface whose triangles run counter-clockwise
    double off;  // by so much of a turn the sum is none: rounding, or the mesh is not closed
};

std::vector<Winding> windings(const test::Mesh& mesh, const std::vector<test::Float3>& points);

// From the nearest triangle.
double distance_to_surface(const test::Mesh& mesh, test::Float3 point);

}  // namespace oracle
