// float_state.hpp - what is left of a ray between two bounces; see State in path.hpp.
#pragma once

#include "oracle/mirrors/mirrors.hpp"

namespace oracle {

// Origin and direction as the nearest floats.
MirrorRay rounded(const MirrorRay& ray, const Quad3& plane);

// The direction as it is, the origin where rsh_spawn lets a ray begin that is kept off its triangle
// by number, written from the rule in kernels/surface/departure.h: of the eight floats around the
// place 0.75 * 2^-24 of the largest coordinate ahead of the point, the one above the plane whose
// way from the point is the shortest, when its part along the ray counts half. The margin of 2^-35
// of the triangle, which rsh allows for the error of its point, is left out.
MirrorRay departed(const MirrorRay& ray, const Quad3& plane);

}  // namespace oracle
