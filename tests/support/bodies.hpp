// bodies.hpp - closed bodies, turned, scaled and moved in double precision and rounded once
// to the floats that are stored; and rays that hit them where it is hard to leave. Traces nothing.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace test {

// As many rays as RSH_TEST_RAYS says; `usual` without it, few on an emulator.
size_t ray_count(size_t usual);

// About the origin, at most 1 from it on each axis.
struct Body {
    std::vector<Double3> vertices;
    std::vector<uint32_t> indices;
};

Body box_body(Double3 half);
// Four sides as wide as the body, and a top that is `top` of it.
Body frustum(double top);
Body sphere_body(uint32_t segments, uint32_t rings);
// Two faces as large as the body that meet in an edge at that angle, closed by two steep ones.
Body wedge(double degrees);
// Not convex: an arrowhead with a notch of that angle. All of it can be seen from the origin.
Body dart(double degrees);

// Columns of a rotation about a random axis.
using Turn = std::array<Double3, 3>;
Turn no_turn();
Turn random_turn(Random& random);
Turn turn_about(Double3 unit_axis, double degrees);
Double3 turned(const Turn& turn, Double3 v);

// Where a body stands.
struct Placement {
    Turn turn = no_turn();
    double scale = 1;
    Double3 offset = {};  // in sizes of the body
};

Mesh placed(const Body& body, const Placement& placement);
inline Double3 centre_of(const Placement& at) {
    return at.scale * at.offset;
}

// A point of a triangle: anywhere, near an edge or a corner down to 2^-27 of it, or on them.
Double3 hard_point(Random& random, const Corners& corners);

// A list of rays at such points, from outside or inside, every fourth one grazing.
Rays rays_at_body(Random& random, const Mesh& mesh, const Placement& at, uint32_t count);

}  // namespace test
