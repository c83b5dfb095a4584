// exact.hpp - the sign of a signed volume of float vectors, exactly.
//
// Expansion arithmetic (Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust
// Geometric Predicates, 1997): a number is a sum of doubles that do not overlap. A product of
// three floats and its rounding errors lie between 2^-447 and 2^387, so nothing under- or
// overflows. Slow; called only where double precision cannot tell.
#pragma once

#include "support/vec.hpp"

namespace oracle {

// Sign (-1, 0, 1) of d . ((p - o) x (q - o)): on which side of the line through p and q a ray
// from o along d passes.
int side_of_edge(test::Float3 o, test::Float3 d, test::Float3 p, test::Float3 q);

}  // namespace oracle
