// hit.hpp - what one ray may and must find at one triangle, from the definition: the three
// signed volumes of the ray with the triangle's edges have one sign. Shares no code with the
// kernels.
//
// Error budget, with u = 2^-24, S the largest component of the direction, |p| that of a corner
// translated to the ray's origin, l(p) that of the same corner sheared across the ray, which is
// |d x p| / S, m that of the triangle's edges, and v what an operation that underflows may err by:
// 2^-126 where denormals may be flushed to 0, else 2^-150. A float routine that shears knows a
// lateral coordinate up to
//     e(p) = (16 u + 2 v / S) |p| + 8 v + v m:  translation 1, slope 6, product 2, difference 2, and
//     some to spare; a flushed component of the direction; operands and results that underflow;
//     and scaling large triangles down. With denormals kept, no difference and no operand errs;
// an edge's volume is S times the determinant of two lateral coordinates, hence off by at most
//     S (2 (e(p) l(q) + e(q) l(p) + e(p) e(q)) + 8 u l(p) l(q) + 8 v k^2)
// with any way to round two products and a difference; the last term is for products that
// underflow, k = 1 for triangles of 2^-20 to 2^20, else m, as a routine has to scale those to unit
// size, by 2^127 at most. Inside those bounds a hit is neither certain nor excluded. With weights w_i
// of one sign, t is a mean of the corners' depths z_i weighted by w_i, hence
//     |t - exact| <= 2 sum(bound_i |z_i - t|) / |sum w| + 32 u max |z_i| + 16 v / S + 4 v,
// and in any case between the least and the greatest depth.
//
// No hit is certain beyond the limits that rsh.h states (rsh_traverse).
#pragma once

#include <rsh/rsh_types.h>

#include "support/mesh.hpp"

namespace oracle {

// What the device does with floats below 2^-126.
enum class Denormals { kMayBeFlushed, kKept };

struct Candidate {
    bool possible = false;  // no correct routine may report it when this is false
    bool certain = false;   // every correct routine must see it
    bool exact =
        false;  // hit when nothing is rounded; edges and vertices belong to the triangle
    double t = 0, u = 0, v = 0;
    double t_low = 0, t_high = 0;  // where a float routine's t may lie
    // Thinner than the limits that rsh.h states for closest hits. Counts and lists of all hits have it
    // all the same, at a t anywhere between those of its corners.
    bool is_slim = false;
    double corner_t_low = 0, corner_t_high = 0;
    double uv_error = 0;
};

// A degenerate or invalid triangle, or an inactive ray, is never possible.
Candidate intersect(const rsh_ray& ray, const test::Corners& corners,
                    Denormals denormals = Denormals::kMayBeFlushed);

}  // namespace oracle
