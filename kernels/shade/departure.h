/* departure.h - where a ray that leaves a surface starts: on its side of the triangle that it
 * leaves, however the triangle is scaled and wherever it lies. Makes no ray.
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
#ifndef RSH_SHADE_DEPARTURE_H
#define RSH_SHADE_DEPARTURE_H

#include "shade/surface.h"

typedef struct departure {
    twofold3 normal;  /* of the triangle, of any length */
    float3 direction; /* of the ray that arrived, scaled by a power of two to 1 .. 2 */
    float3 point;     /* that it hit */
    float3 rest;      /* what rounding left off the point */
    float error;      /* how far from the triangle's plane point + rest may lie */
} departure;

/* As in shade/surface.h. Edges err by u = 2^-24, products by u, their sum by u, and u + v <= 1:
 * with the triangle's extent L the offset errs by 3uL on each axis, and the sum with the corner
 * is exact. */
static void take_barycentric_point(const surface_hit* surface, rsh_hit hit, departure* from)
{
    const triangle_points p = surface->triangle;
    const twofold3 point = exact_sum3(p.v0, hit.u * (p.v1 - p.v0) + hit.v * (p.v2 - p.v0));
    from->point = point.high;
    from->rest = point.low;
    from->error = 0x1p-21f * surface->edges.extent;
}

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
 * them: if they hit the triangle by rounding alone, they meet its plane that far beside it. */
static bool find_point(const surface_hit* surface, rsh_ray ray, float t, departure* from)
{
    const float3 d = from->direction;
    const twofold3 path = exact_product3((float3)(t), d);
    const twofold3 near = exact_sum3(ray.origin_tmin.xyz, path.high);
    const float3 near_rest = near.low + path.low;
    twofold3 from_v0 = exact_sum3(near.high, -surface->triangle.v0);
    from_v0.low += near_rest;
    const float3 normal = from->normal.high;
    const float distance = twofold_dot(from->normal, from_v0).high;
    const float along = 1.0f / dot3(normal, d);
    const float way = distance * along;
    const twofold3 point = exact_sum3(near.high, near_rest - way * d);
    from->point = point.high;
    from->rest = point.low;
    const float share = 0x1p-20f * dot3(fabs(normal), fabs(d)) * fabs(along);
    from->error = (0x1p-36f * surface->edges.extent + share * fabs(distance)) /
                      sqrt(dot3(normal, normal)) +
                  0x1p-46f * (largest3(fabs(near.high)) + largest3(fabs(path.high)));
    return from->error <= 0x1p-21f * surface->edges.extent &&
           fabs(way) <= 0x1p-18f * (surface->edges.extent + largest3(fabs(path.high)));
}

static departure departure_of(const surface_hit* surface, rsh_ray ray, rsh_hit hit)
{
    departure from;
    const float scale = scale_to_one(largest3(fabs(ray.direction_tmax.xyz)));
    from.direction = scale * ray.direction_tmax.xyz;
    from.normal = twofold_cross(surface->edges.edge1, surface->edges.edge2);
    if (!find_point(surface, ray, hit.t / scale, &from))
        take_barycentric_point(surface, hit, &from);
    return from;
}

/* How far ahead of the point, in 2^-24 of its largest coordinate, and what an error along the ray
 * counts beside one across it, squared. With 0 and 1 the error at the 11th of a chain of mirrors
 * is 2.2 times that of rounding to nearest, with these 1.2 times; the first origin's is 1.6
 * times, instead of 1.4. */
#define RSH_PLACE_AHEAD 0.75f
#define RSH_ALONG_SHARE 0.25f

/* The floats next to v, towards the signs of `way`. */
static float3 next_floats(float3 v, float3 way)
{
    const int3 outwards = (v < 0.0f) == (way < 0.0f);
    const float3 next = as_float3(as_int3(v) + select((int3)(-1), (int3)(1), outwards));
    return select(next, copysign((float3)(0x1p-126f), way), v == 0.0f);
}

/* One value per axis, each of two, as the sums of all eight choices: bit i of its number says
 * which of axis i. */
static float8 sums_of_choices(float3 first, float3 second)
{
    const float4 xy = (float4)(first.x, second.x, first.x, second.x) +
                      (float4)(first.y, first.y, second.y, second.y);
    return (float8)(xy + first.z, xy + second.z);
}

static int least_of(float8 values)
{
    const int4 is_high4 = values.hi < values.lo;
    const float4 four = select(values.lo, values.hi, is_high4);
    const int4 index4 = select((int4)(0, 1, 2, 3), (int4)(4, 5, 6, 7), is_high4);
    const int2 is_high2 = four.hi < four.lo;
    const float2 two = select(four.lo, four.hi, is_high2);
    const int2 index2 = select(index4.lo, index4.hi, is_high2);
    return two.y < two.x ? index2.y : index2.x;
}

/* One of the eight floats around a place just ahead of the point. One of them is on the side,
 * if `direction` leads there by RSH_GRAZING: so is the place, and the float that is farther to
 * that side on each axis. */
static float3 rounded_to_side(twofold3 point, float3 side, float3 direction)
{
    const float3 ahead = RSH_PLACE_AHEAD * 0x1p-24f * largest3(fabs(point.high)) * direction;
    const twofold3 place = gathered(point.high, point.low + ahead);
    const float3 next = next_floats(place.high, place.low);
    const float scale = scale_to_one(largest3(fabs(place.high)));
    const float3 a = scale * (ahead - place.low);
    const float3 b = scale * ((next - place.high) - place.low + ahead);
    const float8 along = sums_of_choices(a * direction, b * direction);
    const float8 height = sums_of_choices(a * side, b * side);
    const float8 error = 0x1p-21f * sums_of_choices(fabs(a * side), fabs(b * side));
    const float8 badness =
        sums_of_choices(a * a, b * b) - (1.0f - RSH_ALONG_SHARE) * along * along;
    const int i = least_of(select(badness, (float8)(INFINITY), height < error));
    return (float3)(i & 1 ? next.x : place.high.x, i & 2 ? next.y : place.high.y,
                    i & 4 ? next.z : place.high.z);
}

/* Where a ray may start, before it is rounded. side: the geometric normal, towards the side that
 * the ray leaves to. is_skipped: the ray will not hit the triangle. */
static twofold3 leave_surface(const surface_hit* surface, const departure* from, float3 side,
                              bool is_skipped)
{
    const float margin =
        2.0f * from->error + 0x1p-124f + (is_skipped ? 0.0f : 0x1p-18f * surface->edges.extent);
    const twofold3 point = exact_sum3(from->point, margin * side);
    return gathered(point.high, point.low + from->rest);
}

#endif
