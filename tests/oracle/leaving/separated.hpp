// separated.hpp - which hits of a ray that has left a triangle are none: rsh.h, rsh_traverse, skip.
#pragma once

#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace oracle {

// Whether a plane through the ray's origin, that the ray moves away from, has all of `hit` on its
// other side: the plane of `hit`, or that of `left`, in which corners may also lie. True only
// where doubles of floats, too, can tell that.
bool is_separated(const rsh_ray& ray, const test::Corners& left, const test::Corners& hit);

}  // namespace oracle
