// crossings.hpp - all that the queries count and all may and must find of a ray. A triangle is
// crossed when the three signs of its edges, in the plane across the ray, are the same for the point
// that the ray is there, moved from (0, 0) to (e, e^2) for every e > 0 that is small enough.
#pragma once

#include <vector>

#include "oracle/hit.hpp"
#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace oracle {

struct Crossing {
    uint32_t triangle;
    bool is_certain;  // every correct routine must report it; of others each may choose
    double t_low, t_high;
    float u, v, uv_error;
};

// Of one ray, by ascending triangles; what is not here must not be reported.
using Crossings = std::vector<Crossing>;

// In double precision, with room for how a float routine finds its plane (hit.hpp): near an edge
// nothing is certain, so that a closed mesh must be asked for its parity as well. skip: as
// test::Rays::skip.
std::vector<Crossings> crossings(const test::Mesh& mesh, const std::vector<rsh_ray>& rays,
                                 const std::vector<uint32_t>& skip = {},
                                 Denormals denormals = Denormals::kMayBeFlushed);

// In integers: within the limits of lattice.hpp, and where all components of a direction are 0 or a
// power of two, float corners in that plane are exact and every pair is decided. t is exact for the
// triangles that lattice.hpp describes; with others, only a t within rounding of tmin, of tmax or of
// 0 leaves a pair open. Throws std::invalid_argument beyond these limits.
std::vector<Crossings> lattice_crossings(const test::Mesh& mesh,
                                         const std::vector<rsh_ray>& rays,
                                         const std::vector<uint32_t>& skip = {});

}  // namespace oracle
