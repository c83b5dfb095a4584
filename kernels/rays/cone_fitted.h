/* cone_fitted.h - the bound `cone_fitted`: cones capped by spheres, each fitted to all its
 * rays, 16 of them side by side; and the test of such nodes against a sphere.
 *
 * A node's rays start within `radius` of the apex C and leave within the half-angle a of the
 * axis x, so they stay in the bare cone grown by the radius. The test is exact: the distance
 * of a point to the cone, against S, the sum of both radii. With w = centre - C, z = w.x along
 * and q = |w x x| across the axis, the distance to the cone's side is q cos a - z sin a,
 * negative inside. A point behind the apex of a cone narrower than 90 degrees, z cos a +
 * q sin a < 0, is |w| away instead. That condition also holds deep inside a wider cone, around
 * which no point is closest to the apex: so whether it is inside comes first, and a wide cone
 * is tested by its side alone. Squares are compared, so that no root is taken:
 *    narrow, behind:  |w|^2 > S^2
 *    narrow, else:    z sin a + S < 0 or  (q cos a)^2 > (z sin a + S)^2
 *    wide:            z sin a + S < 0 and (q cos a)^2 < (z sin a + S)^2
 *
 * The half-angle is stored as `spread`: sin a up to 90 degrees, 2 - sin a beyond; it grows with
 * a, and so a maximum of spreads is that of the angles. Between 87 and 93 degrees a root of
 * 1 - sin^2 would be noise: spreads there count as 93 degrees. From 120 on a cone counts as
 * all directions: it rejects too little to be worth a test.
 *
 * Rounding (u = 2^-24): z 3u|w|, q 4u|w|, the axis' length 16u, cos a from 1 - sin^2 10u down
 * to |cos a| = 0.05, products and squares 4u|w|: 37u|w| at most. A hit that mesh/intersect.h reports
 * can lie 45u|v| off, with |v| <= |w| + S. Together 82u; the padding 2^-17 (|w|_1 + S) is 128u.
 * Underflow and rounding are monotonic and cannot turn a comparison round; what overflows or is
 * NaN is kept.
 */
#ifndef RSH_RAYS_CONE_FITTED_H
#define RSH_RAYS_CONE_FITTED_H

#include "mesh/triangles.h"

#define RSH_VECTORS (16 / RSH_WIDTH)

/* Rows of a group, see rsh_cone_group: apex (3), radius, axis (3), spread. */
#define RSH_CONE_ROWS 8
#define RSH_RADIUS_ROW 3
#define RSH_SPREAD_ROW 7

#define RSH_ALL_DIRECTIONS 2.0f

/* 16 nodes, made ready for the test. */
typedef struct rsh_cones {
    floatv apex[3][RSH_VECTORS], axis[3][RSH_VECTORS], radius[RSH_VECTORS];
    floatv sine[RSH_VECTORS], cosine2[RSH_VECTORS];
    intv is_wide[RSH_VECTORS], is_everywhere[RSH_VECTORS];
} rsh_cones;

static void set_cones(rsh_cones* cones, __global const float* group)
{
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        __global const float* row = group + RSH_WIDTH * v;
        for (uint axis = 0; axis < 3; ++axis) {
            cones->apex[axis][v] = load_lanes(row + 16 * axis);
            cones->axis[axis][v] = load_lanes(row + 16 * (4 + axis));
        }
        cones->radius[v] = load_lanes(row + 16 * RSH_RADIUS_ROW);
        const floatv spread = load_lanes(row + 16 * RSH_SPREAD_ROW);
        cones->is_wide[v] = spread > (floatv)(1.0f);
        cones->is_everywhere[v] = spread == (floatv)(RSH_ALL_DIRECTIONS);
        cones->sine[v] = select(spread, (floatv)(2.0f) - spread, cones->is_wide[v]);
        cones->cosine2[v] = (floatv)(1.0f) - cones->sine[v] * cones->sine[v];
    }
}

/* Which of the 16 nodes can meet the sphere (w: radius, negative: never hit), a bit each. */
static uint cones_meeting(const rsh_cones* cones, float4 sphere)
{
    if (!(sphere.w >= 0.0f)) return 0;
    uint met = 0;
    for (uint v = 0; v < RSH_VECTORS; ++v) {
        const floatv x = cones->axis[0][v], y = cones->axis[1][v], axis_z = cones->axis[2][v];
        const floatv wx = sphere.x - cones->apex[0][v];
        const floatv wy = sphere.y - cones->apex[1][v];
        const floatv wz = sphere.z - cones->apex[2][v];
        const floatv z = wx * x + wy * y + wz * axis_z;
        const floatv nx = wy * axis_z - wz * y;
        const floatv ny = wz * x - wx * axis_z;
        const floatv nz = wx * y - wy * x;
        const floatv q2 = nx * nx + ny * ny + nz * nz, z2 = z * z;
        const floatv sine = cones->sine[v], cosine2 = cones->cosine2[v];
        const floatv sum = cones->radius[v] + sphere.w;
        const floatv reach = sum + 0x1p-17f * (fabs(wx) + fabs(wy) + fabs(wz) + sum);
        const floatv side = z * sine + reach;
        const intv is_outside = side < (floatv)(0.0f), is_beside = q2 * cosine2 > side * side;
        const intv is_behind =
            (z < (floatv)(0.0f)) & (q2 * (sine * sine) < z2 * cosine2);
        const intv is_past = q2 + z2 > reach * reach;
        const intv far_narrow = select(is_outside | is_beside, is_past, is_behind);
        const intv far_wide = is_outside & (q2 * cosine2 < side * side);
        const intv is_far = select(far_narrow, far_wide, cones->is_wide[v]) &
                            (q2 + z2 < (floatv)(INFINITY));
        const intv meets = (cones->radius[v] >= (floatv)(0.0f)) &
                           (cones->is_everywhere[v] | (is_far == (intv)(0)));
        met |= RSH_LANE_BITS(meets) << (RSH_WIDTH * v);
    }
    return met;
}

#endif
