// closest.hpp - brute force over all rays and triangles in double precision. Threads and vectors
// make 65 K rays x 2 M triangles a matter of minutes; nothing is culled but what no rounding could
// turn into a hit. judge.hpp compares a float routine's answers with it.
#pragma once

#include <limits>
#include <vector>

#include "oracle/hit.hpp"
#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace oracle {

struct Answer {
    uint32_t primitive = RSH_NO_HIT;  // of the exact closest hit, lowest index of equal t
    double t = 0;
    // The nearest hit that no correct routine may miss lies no farther than this.
    double certain_by = std::numeric_limits<double>::infinity();
    // Several answers are correct: the ray passes within rounding of an edge, of another hit's
    // t, or of its own tmin or tmax.
    bool ambiguous = false;
    bool possible = false;   // a correct routine may report some hit
    uint32_t undecided = 0;  // triangles that a correct routine may see or not
};

// skip: as test::Rays::skip.
std::vector<Answer> closest(const test::Mesh& mesh, const std::vector<rsh_ray>& rays,
                            const std::vector<uint32_t>& skip = {},
                            Denormals denormals = Denormals::kMayBeFlushed);

// Share of the rays that are ambiguous.
double ambiguous_share(const std::vector<Answer>& answers);

}  // namespace oracle
