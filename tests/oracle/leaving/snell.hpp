// snell.hpp - a ray at the plane of a triangle, in long double, and how far a float routine may be
// off it.
//
// With u = 2^-24, and square roots within 6u and divisions within 5u, as OpenCL allows: a unit vector
// made of an exact one errs by 1.5u + 6u + 5u in each component, relative to it; a normal, whose
// cross product errs by 4u, by 17u; their product c, the cosine, by 33u sum |d_i n_i|.
// Snell's law makes a refracted ray where D = eta^2 - 1 + c^2 is positive, eta: the index behind
// the surface over that before it, within 5u. However that is factored, D errs by
//     2 * 5u eta max(eta, 1) + 3u |eta^2 - 1| + 66u c sum |d_i n_i| + 2u (c^2 + |D|).
// With f = sqrt(D), off by b / f for an error b of D, the ray is d + (c - f) n, of length eta.
#pragma once

#include "support/mesh.hpp"
#include "support/rays.hpp"

namespace oracle {

constexpr long double kFloatUnit = 0x1p-24L;

struct PlaneHit {
    test::Long3 incident;  // unit
    test::Long3 normal;    // unit, towards where the ray comes from
    long double cosine;    // of the angle between the two, 0 .. 1
    long double error;     // of that cosine
    bool is_outside;       // the ray comes from where corners are counter-clockwise
    bool is_sided;         // a float routine knows that side as well
    bool is_well_shaped;   // neither a sliver nor seen along its plane
    long double extent;    // of the triangle, and how far it is from the ray's origin
    long double reach;
};

PlaneHit plane_hit(const rsh_ray& ray, const test::Corners& corners);

struct Snell {
    long double eta;
    long double discriminant, error;  // D and b
    bool is_total, is_refracted;      // neither: open
    long double reflectance;          // Fresnel's
};

// An index that is not positive and finite is 1.
Snell snell_at(const PlaneHit& surface, float index);

test::Long3 mirrored(const PlaneHit& surface);
test::Long3 refracted(const PlaneHit& surface, const Snell& snell);
// Of any component; infinite unless it is refracted.
long double refracted_error(const PlaneHit& surface, const Snell& snell);

}  // namespace oracle
