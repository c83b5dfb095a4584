/* offset.h - where a ray that leaves a surface starts, so that it does not hit the triangle
 * that it leaves, however the triangle is scaled and wherever it lies. Makes no ray.
 *
 * As Waechter and Binder (Ray Tracing Gems, 2019, chapter 6), the origin moves along the
 * geometric normal n to the side that the ray leaves to. They found the distance by trial, in
 * scenes of ordinary size: 256 ulp of the coordinates, or 1/65536 near zero. That is 16 units
 * where coordinates are 1e6, many times a scene of 1e-6, and too little where a triangle 1e3
 * wide passes near zero. Here it is bounded from the two errors that it must outweigh (u =
 * 2^-24; L: the triangle's extent, the largest difference of its corners along an axis; p: the
 * point hit).
 *
 *  1. Point off the plane. Edges err by u, products by u, their sum by u, and u + v <= 1: the
 *     offset from the corner errs by 3uL on each axis, the sum with the corner by u |p_axis|.
 *     Along n:  3 sqrt(3) u L + u |n|.|p|  where |n|.|p| = sum of |n_axis p_axis|. Adding the
 *     distance to p rounds once more: u |n|.|p|.
 *  2. Test of the new ray (mesh/intersect.h). Seen from a point above the triangle, corners lie
 *     within M <= L + distance on each axis; they move by 11uM on two axes, by sqrt(2) 11uM
 *     along n at most, and with them every point between them. The depth errs by 2^-20 M, which
 *     counts along the ray: sqrt(3) 2^-20 M at most. Together below 2.8 * 2^-20 M.
 *
 * So  distance = 2^-18 L + 2^-22 |n|.|p|  leaves the line of every ray that moves away from the
 * surface at t < 0: 2^-18 L covers 2.8 * 2^-20 L + 0.4 * 2^-20 L, 2^-22 covers 2u with a factor
 * 2 to spare, and 2^-124 what a device flushes to zero. n itself errs by a few ulp
 * (shade/surface.h): moves along the plane are harmless.
 */
#ifndef RSH_SHADE_OFFSET_H
#define RSH_SHADE_OFFSET_H

#include "shade/surface.h"

/* The cosine between surface and ray below which "moves away" could be rounding. */
#define RSH_GRAZING 0x1p-18f

static float triangle_extent(triangle_points p)
{
    const float3 low = fmin(p.v0, fmin(p.v1, p.v2));
    const float3 high = fmax(p.v0, fmax(p.v1, p.v2));
    return largest3(high - low);
}

/* `side`: the geometric normal, towards the side that the ray leaves to. */
static float3 leave_surface(const surface_hit* surface, float3 side)
{
    const float distance = 0x1p-18f * triangle_extent(surface->triangle) +
                           0x1p-22f * dot3(fabs(side), fabs(surface->point)) + 0x1p-124f;
    return surface->point + distance * side;
}

/* A unit direction that leads to `side`. One that does not, because the normal that it was
 * computed with is not the triangle's, is mirrored in the triangle's plane, as if it met the
 * surface twice. */
static float3 keep_on_side(float3 direction, float3 side)
{
    const float cosine = dot3(direction, side);
    if (cosine >= RSH_GRAZING) return direction;
    return unit3(direction + (fmax(-cosine, RSH_GRAZING) - cosine) * side);
}

#endif
