/* departure.h - where rays of a block that leave surfaces start: each on its side of the triangle that
 * it leaves, however the triangle is scaled and wherever it lies. Makes no ray.
 *
 * The ray does not hit that triangle, which is told by its number, nor what lies behind the
 * triangle's plane (mesh/leaving.h). So the origin only has to be on the right side of the plane:
 * farther from it than the error of the point, and once more, for the test that decides it. Of
 * the floats around the point one on that side is taken: two ulp away at most.
 *
 * If that one were simply the nearest, each ray would start a share of an ulp above its surface.
 * Between curved mirrors such a shift, always to the same side of the ray, adds up from bounce
 * to bounce, where roundings cancel. Errors along the ray do nothing. So the float is taken that
 * lies least beside the ray, and among floats around a point a little ahead, where more of them
 * are on the right side.
 *
 * A ray whose triangle is not told by number must be kept off it by distance. Seen from a point
 * above the triangle, corners lie within M <= L + distance on each axis (L: the triangle's
 * extent, u = 2^-24); what the test of mesh/intersect.h takes for a hit is within 47uM of the
 * triangle: 2^-18 L, that is 64u L, suffices.
 *
 * What this cannot do: where two triangles meet at an edge, an origin within some ulp of the
 * scene's coordinates of that edge may be on the wrong side of the other one; and what is nearer
 * to the surface than that is not resolved. Of a triangle much larger than its distance from
 * the origin of coordinates, the corners' own rounding decides where it is.
 */
#ifndef RSH_SURFACE_DEPARTURE_H
#define RSH_SURFACE_DEPARTURE_H

#include "surface/surface.h"

typedef struct departure_lanes {
    twofold3v normal;  /* of the triangle, of any length */
    float3v direction; /* of the ray that arrived, scaled by a power of two to 1 .. 2 */
    float3v point;     /* that it hit */
    float3v rest;      /* what rounding left off the point */
    floatv error;      /* how far from the triangle's plane point + rest may lie */
} departure_lanes;

/* The point where the ray meets the triangle's plane, rounded once: the hit's t leads near it,
 * and the distance from the plane that is left is taken off along the ray. So neither the
 * size of the triangle nor the length of the ray counts, as they do in t, u and v.
 *
 * What is left errs by 2^-42 of the size of its terms (mesh/twofold.h): a component of the
 * normal by 2^-39, as edges are below 2; the normal by 2^-38; its product with the way from v0,
 * sqrt(3) L at most, by 2^-37 L; the distance by 2^-36 L / |normal| with all else. And what is
 * taken off errs by the share that `along` does, 4u of its terms and 5u for the quotient, and by
 * 3u for two products and a sum: 12u of the terms. The low parts are floats, too: of a sum below u of
 * the point's coordinates and of the path's each, they are rounded three times, 4u^2 = 2^-46.
 * Slivers and rays along the plane, of which all that says little, keep the barycentric point. So
 * do rays that meet the plane far from what t says, as t errs by 11u / sine of the angle between
 * them: if they hit the triangle by rounding alone, they meet its plane that far beside it. A mask: where
 * it is found. */
static intv find_points(const surface_lanes* surface, const ray_lanes* block, floatv t,
                        departure_lanes* from)
{
    const float3v d = from->direction;
    const twofold3v path = exact_product3_v((float3v){t, t, t}, d);
    const twofold3v near = exact_sum3_v(block->origin, path.high);
    const float3v near_rest = sum_v(near.low, path.low);
    twofold3v from_v0 = exact_sum3_v(near.high, opposite_v(surface->v0));
    from_v0.low = sum_v(from_v0.low, near_rest);
    const float3v normal = from->normal.high;
    const floatv distance = twofold_dot_v(from->normal, from_v0).high;
    const floatv along = (floatv)(1.0f) / dot_v(normal, d);
    const floatv way = distance * along;
    const twofold3v point = exact_sum3_v(near.high, minus_v(near_rest, scaled_v(way, d)));
    from->point = point.high;
    from->rest = point.low;
    const floatv share = 0x1p-20f * dot_v(fabs_v(normal), fabs_v(d)) * fabs(along);
    const floatv extent = surface->edges.extent, reach = largest_v(fabs_v(path.high));
    from->error = (0x1p-36f * extent + share * fabs(distance)) / sqrt(dot_v(normal, normal)) +
                  0x1p-46f * (largest_v(fabs_v(near.high)) + reach);
    return (from->error <= 0x1p-21f * extent) & (fabs(way) <= 0x1p-18f * (extent + reach));
}

/* As in surface/surface.h. Edges err by u = 2^-24, products by u, their sum by u, and u + v <= 1:
 * with the triangle's extent L the offset errs by 3uL on each axis, and the sum with the corner
 * is exact. */
static void take_barycentric_points(const surface_lanes* surface, const ray_lanes* block,
                                    intv is_kept, departure_lanes* from)
{
    const twofold3v point = exact_sum3_v(surface->v0, offset_from_v0(surface, block));
    from->point = select_v(point.high, from->point, is_kept);
    from->rest = select_v(point.low, from->rest, is_kept);
    from->error = select(0x1p-21f * surface->edges.extent, from->error, is_kept);
}

RSH_CALLED static departure_lanes departures_of(const surface_lanes* surface,
                                                const ray_lanes* block)
{
    departure_lanes from;
    const floatv scale = scale_to_one_v(largest_v(fabs_v(block->direction)));
    from.direction = scaled_v(scale, block->direction);
    from.normal = twofold_cross_v(surface->edges.edge1, surface->edges.edge2);
    const intv is_kept = find_points(surface, block, block->t / scale, &from);
    take_barycentric_points(surface, block, is_kept, &from);
    return from;
}

/* Where rays may start, before that is rounded. side: the geometric normal, towards the side that
 * they leave to. is_skipped: they will not hit the triangle. */
static twofold3v leave_surfaces(const surface_lanes* surface, const departure_lanes* from,
                                float3v side, bool is_skipped)
{
    const floatv off = (floatv)(is_skipped ? 0.0f : 0x1p-18f) * surface->edges.extent;
    const floatv margin = 2.0f * from->error + 0x1p-124f + off;
    const twofold3v point = exact_sum3_v(from->point, scaled_v(margin, side));
    return gathered_v(point.high, sum_v(point.low, from->rest));
}

#endif
