// path.hpp - a ray's way from mirror to mirror in 113 bits, with another state between bounces
// where that is asked for.
#pragma once

#include <functional>

#include "oracle/mirrors/mirrors.hpp"

namespace oracle {

// After a bounce: the ray that leaves (skip: the triangle of the bounce), and where exactly it
// goes.
struct Step {
    MirrorRay ray;
    MirrorHit next;
};
using Path = std::vector<Step>;

// What a ray is before it goes on, of what it is exactly. `plane`: the normal of the triangle that
// it leaves, on the ray's side, of any length.
using State = std::function<MirrorRay(const MirrorRay& exact, const Quad3& plane)>;

// Ends early only where a ray hits nothing.
Path exact_path(const Mirrors& mirrors, const MirrorRay& start, uint32_t bounces);

// The same with a state put in at each of the first bounces. Ends early where it parts: where the
// next triangle is not that of the exact path.
Path path_with(const State& state, uint32_t state_count, const Mirrors& mirrors,
               const MirrorRay& start, const Path& exact);

}  // namespace oracle
