/* cone_sphere.h - may a ray of a node meet a sphere? Four sibling nodes at a time.
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
 * rejects spheres behind the origins as well and costs one comparison.
 *
 * Rounding (u = 2^-24): z 3u|w|, q 4u|w|, cos a = sqrt(1 - sin^2) 10u down to cos a = 0.05, products
 * 2u|w|: 20u|w| at most, that is 2^-19.6 |w|. A hit that intersect.h reports can lie 2^-20 |v| off,
 * with |v| <= |w| + S. The padding 2^-18 (|w|_1 + S) is larger than both together, and what cannot
 * be compared (overflow, NaN) is kept.
 */
#ifndef RSH_CONE_SPHERE_H
#define RSH_CONE_SPHERE_H

#include "kernel_types.h"
#include "vector.h"

static int4 may_meet(const rsh_node_quad* node, float4 sphere)
{
    const float4 wx = sphere.x - node->apex_x;
    const float4 wy = sphere.y - node->apex_y;
    const float4 wz = sphere.z - node->apex_z;
    const float4 z = wx * node->axis_x + wy * node->axis_y + wz * node->axis_z;
    const float4 nx = wy * node->axis_z - wz * node->axis_y;
    const float4 ny = wz * node->axis_x - wx * node->axis_z;
    const float4 nz = wx * node->axis_y - wy * node->axis_x;
    const float4 q = sqrt(nx * nx + ny * ny + nz * nz);
    const float4 sine = node->sine;
    const float4 cosine = sqrt(fmax((float4)(0.0f), 1.0f - sine * sine));

    const float4 to_side = q * cosine - z * sine;
    const float4 to_apex = sqrt(wx * wx + wy * wy + wz * wz);
    const float4 distance = select(to_side, to_apex, z * cosine + q * sine < 0.0f);
    const float4 reach = node->radius + sphere.w;
    const float4 padding = 0x1p-18f * (fabs(wx) + fabs(wy) + fabs(wz) + reach);

    const int4 is_far = (distance > reach + padding) & (distance < INFINITY);
    return (node->radius >= 0.0f) & ((sine > 1.0f) | (is_far == 0));
}

#endif
