// closest.hpp - brute force over all rays and triangles in double precision, and the judgement
// of a float routine's answers by it. Threads and vectors make 65 K rays x 2 M triangles a
// matter of minutes; nothing is culled but what no rounding could turn into a hit.
#pragma once

#include <gtest/gtest.h>

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
    bool possible = false;  // a correct routine may report some hit
};

// skip: as test::Rays::skip.
std::vector<Answer> closest(const test::Mesh& mesh, const std::vector<rsh_ray>& rays,
                            const std::vector<uint32_t>& skip = {});

// Every hit is one that a correct float routine may report.
::testing::AssertionResult hits_are_correct(const std::vector<Answer>& answers,
                                            const test::Mesh& mesh,
                                            const std::vector<rsh_ray>& rays,
                                            const std::vector<rsh_hit>& hits);

// Bit `bit` of every mask is set when a hit is certain and clear when none is possible.
::testing::AssertionResult occlusion_is_correct(const std::vector<Answer>& answers,
                                                const std::vector<rsh_ray>& rays,
                                                const std::vector<uint32_t>& masks,
                                                uint32_t bit);

// Share of the rays that are ambiguous.
double ambiguous_share(const std::vector<Answer>& answers);

}  // namespace oracle
