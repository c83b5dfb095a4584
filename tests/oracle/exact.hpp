// exact.hpp - the sign of a signed volume of float vectors, exactly.
//
// Expansion arithmetic (Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust
// Geometric Predicates, 1997): a number is a sum of doubles that do not overlap. A product of
// three floats and its rounding errors lie between 2^-447 and 2^387, so nothing under- or
// overflows. Slow; gone through only where long double cannot tell.
#pragma once

#include <array>

#include "support/vec.hpp"

namespace oracle {

// Sign (-1, 0, 1) of d . ((p - o) x (q - o)): on which side of the line through p and q a ray
// from o along d passes.
int side_of_edge(test::Float3 o, test::Float3 d, test::Float3 p, test::Float3 q);

// Sign of ((b - a) x (c - a)) . (o - a), of the corners a, b, c of a triangle: 1 on the side from
// which they run counter-clockwise, 0 in its plane.
int side_of_plane(test::Float3 o, const std::array<test::Float3, 3>& corners);

}  // namespace oracle
