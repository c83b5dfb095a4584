// found.hpp - every triangle that a ray may hit: all rays against all triangles, in double precision.
// Nothing is culled but what no rounding could turn into a hit.
#pragma once

#include <functional>
#include <vector>

#include "oracle/hit.hpp"
#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace oracle {

struct Found {
    uint32_t triangle;
    Candidate candidate;  // a possible one
};

// Once for each ray, on any thread; `found` ascends by triangles and is the callee's to take.
using TakeFound = std::function<void(size_t ray, std::vector<Found>& found)>;

// skip: as test::Rays::skip.
void find_all(const test::Mesh& mesh, const std::vector<rsh_ray>& rays,
              const std::vector<uint32_t>& skip, Denormals denormals, const TakeFound& take);

}  // namespace oracle
