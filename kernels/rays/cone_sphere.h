/* cone_sphere.h - may a ray of a node meet a sphere? Any number of nodes and spheres at once, a
 * lane each.
 *
 * A node's rays lie in its cone (apex C, axis x, half-angle a) grown by its radius, so the bare
 * cone is tested against a sphere of radius S = sum of both radii. With w = centre - C:
 *
 *    q |      . centre     z = w.x along, q = |w x x| across the axis
 *      |   .               distance to the cone's side: q cos a - z sin a (negative inside),
 *      | .  a              but |w| where the apex is closest: z cos a + q sin a < 0
 *      +-----------> z
 *
 * Roger et al. 2007 test the side only, from an apex moved back by S / sin a; the second case
 * rejects spheres behind the origins as well and costs one comparison. Squares are compared,
 * with cos^2 a = 1 - sin^2 a, so that no root is taken.
 *
 * Rounding (u = 2^-24): z 3u|w|, q 4u|w|, the axis' length 16u, cos a from 1 - sin^2 10u down
 * to cos a = 0.05, products and squares 4u|w|: 37u|w| at most. A hit that mesh/intersect.h
 * reports can lie 47u|v| off, with |v| <= |w| + S. Together 84u; the padding 2^-17 (|w|_1 + S)
 * is 128u.
 *
 * Underflow: squares of what is below 1e-19 lose their bits, below 1e-23 all of them. So w and
 * S are first scaled by the power of two, hence exactly, that brings the largest of them to 1
 * .. 2. Where a hit is possible, the rest of the padding then leaves
 *    z sin a + S - q cos a >= 44u, and so  (z sin a + S)^2 - (q cos a)^2 >= (44u)^2 > 2^-38,
 * the same of S and |w|, while a product loses at most 2^-126, whether a device flushes it to
 * zero or not. The differences themselves are not scaled yet: 2^-124 in each sphere's radius
 * (bvh/spheres.cl) makes up for the 2^-126 that each of them may lose. What is infinite, NaN,
 * or above 2^127 is kept.
 */
#ifndef RSH_RAYS_CONE_SPHERE_H
#define RSH_RAYS_CONE_SPHERE_H

#include "lanes/lanes.h"
#include "rays/types.h"

/* Nodes and spheres, lane by lane: the arguments of the test. */
#define RSH_DEFINE_CONE_SPHERE(name, F, I)                                                   \
    typedef struct name##_lanes {                                                            \
        F apex_x, apex_y, apex_z, radius, axis_x, axis_y, axis_z, sine;                      \
        F centre_x, centre_y, centre_z, centre_radius;                                       \
    } name##_lanes;                                                                          \
    static I name(const name##_lanes* l)                                                     \
    {                                                                                        \
        const F far_x = l->centre_x - l->apex_x;                                             \
        const F far_y = l->centre_y - l->apex_y;                                             \
        const F far_z = l->centre_z - l->apex_z;                                             \
        const F radii = l->radius + l->centre_radius;                                        \
        const F size = fmax(fmax(fabs(far_x), fabs(far_y)), fmax(fabs(far_z), radii));       \
        const F scale = as_##F(0x7f000000 - (as_##I(size) & 0x7f800000));                    \
        const F wx = scale * far_x, wy = scale * far_y, wz = scale * far_z;                  \
        const F sum = scale * radii;                                                         \
        const F z = wx * l->axis_x + wy * l->axis_y + wz * l->axis_z;                        \
        const F nx = wy * l->axis_z - wz * l->axis_y;                                        \
        const F ny = wz * l->axis_x - wx * l->axis_z;                                        \
        const F nz = wx * l->axis_y - wy * l->axis_x;                                        \
        const F q2 = nx * nx + ny * ny + nz * nz;                                            \
        const F z2 = z * z;                                                                  \
        const F sine2 = l->sine * l->sine;                                                   \
        const F cosine2 = 1.0f - sine2;                                                      \
        const F reach = sum + 0x1p-17f * (fabs(wx) + fabs(wy) + fabs(wz) + sum);             \
        const F side = z * l->sine + reach;                                                  \
        const I is_behind = (z < 0.0f) & (q2 * sine2 < z2 * cosine2);                        \
        const I far_side = (side < 0.0f) | (q2 * cosine2 > side * side);                     \
        const I far_apex = q2 + z2 > reach * reach;                                          \
        const I is_far =                                                                     \
            ((is_behind & far_apex) | ((is_behind == 0) & far_side)) & (q2 + z2 < INFINITY); \
        return (l->radius >= 0.0f) & (l->centre_radius >= 0.0f) &                            \
               ((l->sine > 1.0f) | (is_far == 0));                                           \
    }

#endif
