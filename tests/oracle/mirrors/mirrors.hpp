// mirrors.hpp - a ray among mirrors in 113 bits, from the definition: the nearest of all flat
// triangles, the normal interpolated there, the direction mirrored about it. So chains of many
// bounces are known far beyond what floats can tell; which of its bits a caller keeps between
// bounces is the caller's choice. All materials are taken for mirrors.
#pragma once

#include <cfloat>

#include <vector>

#include <rsh/rsh_types.h>

#include "support/mesh.hpp"

namespace oracle {

// Where neither type has 113 bits, the errors of floats are still known to 2^-29 of them.
#if LDBL_MANT_DIG < 113 && defined(__SIZEOF_FLOAT128__)
__extension__ using Quad = __float128;
#else
using Quad = long double;
#endif
using Quad3 = test::Vec3<Quad>;

struct MirrorRay {
    Quad3 origin, direction;  // of any length
    uint32_t skip;            // the triangle that it left, or RSH_NO_HIT
};

struct MirrorHit {
    uint32_t triangle = RSH_NO_HIT;
    Quad3 point;
};

struct Ball {
    test::Double3 centre;
    double radius;
};

class Mirrors {
public:
    // No degenerate triangles; normals at the vertices, or none.
    Mirrors(const test::Mesh& mesh, const std::vector<test::Float3>& normals);

    // The first triangle from the origin on.
    MirrorHit nearest(const MirrorRay& ray) const;

    // Where the ray meets the plane of a triangle.
    Quad3 point_in_plane(const MirrorRay& ray, uint32_t triangle) const;

    // Starts at the point hit. The direction is as long as before; one that the interpolated
    // normal sends to the wrong side of the triangle is mirrored in its plane, too.
    MirrorRay reflected(const MirrorRay& ray, const MirrorHit& hit) const;

    // Of the triangle's plane, of any length, to the side from which its corners are
    // counter-clockwise.
    Quad3 plane_normal(uint32_t triangle) const;
    // Of the triangle that a ray leaves, to the ray's side.
    Quad3 normal_towards(const MirrorRay& leaving) const;

private:
    Quad3 normal_at(const MirrorHit& hit) const;

    std::vector<test::Corners> triangles_;
    std::vector<Ball> balls_;             // around the triangles
    std::vector<test::Corners> normals_;  // of the corners; empty: flat
};

}  // namespace oracle
