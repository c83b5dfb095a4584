/* leaving.h - rays that start on a triangle: which hits near their origin are none.
 *
 * Such a ray never hits the triangle that it left, which is told by its number. The triangles
 * around that one pass through the origin, or within rounding of it, and the test of
 * mesh/intersect.h moves their corners by up to sqrt(2) 11u |.| across the ray (u = 2^-24, |.|:
 * the farthest component of a corner, from the origin): beside an edge it may see one of them
 * ahead of a ray that has it behind. Therefore a hit of such a ray is believed only if no
 * plane separates ray and triangle. A plane through the origin that the ray moves away from,
 * or in, has the whole ray on one side; a triangle whose three corners are beyond it is not
 * hit. Two planes are tried, that of the triangle hit and that of the triangle left: the first
 * one tells where the two meet in a valley, the second where they meet in a ridge or a plane.
 *
 * Corners count as beyond the plane of the triangle hit only farther than the error of that
 * decision: a ray may start in a triangle that it goes through. Corners in the plane of the triangle
 * left, as far as that error tells, count as beyond it: a ray may start in a corner or an edge that
 * both share, and be stopped by it. The error is 2^-42 of all products (mesh/twofold.h), 40u^2 of
 * them at most: 6 |a| |b| |.| for the shortest two edges a, b, so that a triangle may be lost that is
 * less than 3 * 2^-41 |.| / sine above that plane, with the sine of the angle between a and b. The ray
 * meets it at a depth of 3 * 2^-25 |.| / sine; unless it left a flat cap, a tenth of what t errs by.
 * Nor does it cost where nothing is near.
 * Spawned rays leave at RSH_GRAZING, 2^-16, or more, so that a point at depth s along the ray is
 * 2^-16 s or more above the plane left, and is mistaken for one of a triangle below that plane
 * only while 2^-16 s <= 15.6u |.|, that is s <= 0.061 |.|. A hit at depth s has the corners of
 * its triangle within s + L, L being the triangle's extent: doubtful are those with s <= L / 15.
 */
#ifndef RSH_MESH_LEAVING_H
#define RSH_MESH_LEAVING_H

#include "mesh/batch.h"
#include "mesh/intersect.h"
#include "mesh/plane.h"

/* Share of a triangle's extent: up to that depth along a ray's largest axis its hit is doubtful,
 * and is_separated must be asked. */
#define RSH_DOUBTFUL_DEPTH 0.067f

/* The triangles that rays have left. */
typedef struct triangles_left {
    mesh_view mesh;
    __global const float* vertices;
    __global const uint* indices;
    __global const rsh_ray* rays;
    __global const uint* skip; /* a triangle per ray; 0: no ray has left one */
#if RSH_FILTER
    hit_filter filter; /* what rays do not see, be they from a triangle or not */
#endif
#if RSH_BATCHES
    scene_batch batch;
#endif
} triangles_left;

/* The triangle that a ray has left, by its number in the mesh; RSH_NO_HIT: none. */
static uint triangle_left_by(const triangles_left* left, uint ray)
{
    const uint skip = left->skip[ray];
#if RSH_BATCHES
    if (!left->batch.skip_corners || skip == RSH_NO_HIT) return skip;
    if (skip >= left->batch.skip_count) return RSH_OTHER_BATCH;
    const uint triangle = left->batch.skip_numbers[skip] - left->batch.first_triangle;
    return triangle < left->mesh.triangle_count ? triangle : RSH_OTHER_BATCH;
#else
    return skip;
#endif
}

/* False: there is none, or it is no triangle. */
static bool load_triangle_left_by(const triangles_left* left, uint ray, triangle_points* out)
{
    const uint skip = left->skip[ray];
#if RSH_BATCHES
    if (left->batch.skip_corners) {
        if (skip >= left->batch.skip_count) return false;
        __global const float* at = left->batch.skip_corners + 9ul * skip;
        *out = (triangle_points){vload3(0, at), vload3(1, at), vload3(2, at)};
        return true;
    }
#endif
    return skip < left->mesh.triangle_count &&
           load_triangle(left->mesh, left->vertices, left->indices, skip, out);
}

/* The side of a plane through the origin that the ray moves to: 1 or -1; 0: it stays in it, as
 * far as rounding tells. */
static int side_ahead(const triangle_plane* plane, float3 direction)
{
    const float3 normal = plane->normal.high;
    const float along = dot3(normal, direction);
    const float error =
        0x1p-21f * dot3(fabs(normal) + 0x1p-21f * plane->products, fabs(direction));
    return along > error ? 1 : along < -error ? -1 : 0;
}

/* The side of the plane through the origin that a corner is on: 1, that of the normal; -1; 0: in
 * the plane, as far as rounding tells. */
static int side_of(const triangle_plane* plane, float3 origin, float3 corner)
{
    const twofold3 to_corner = exact_sum3(corner, -origin);
    const float height = twofold_dot(plane->normal, to_corner).high;
    const float error = 0x1p-42f * dot3(plane->products, fabs(to_corner.high));
    return height > error ? 1 : height < -error ? -1 : 0;
}

/* False: a corner of the triangle is ahead of the ray in the plane's direction, sure of it in
 * floats. With edges a, b, scaled so that nothing underflows, a component of the normal errs by
 * 3u of its two products and u of itself, that is 8u |a| |b|; a distance from the plane, whose three
 * components of the normal sum up to 4 |a| |b| at most, by 22u for these, 4u each for the corner and
 * the products, 8u for two sums: 38u |a| |b| |corner - origin|, of 64u. */
static bool may_separate(triangle_points plane, rsh_ray ray, triangle_points triangle)
{
    const float3 origin = ray.origin_tmin.xyz, direction = ray.direction_tmax.xyz;
    const float3 edge1 = plane.v1 - plane.v0, edge2 = plane.v2 - plane.v0;
    const float scale = scale_to_one(largest3(fmax(fabs(edge1), fabs(edge2))));
    const float3 a = scale * edge1, b = scale * edge2;
    const float3 normal = a.yzx * b.zxy - a.zxy * b.yzx;
    const float error = 0x1p-18f * largest3(fabs(a)) * largest3(fabs(b));
    const float along = dot3(normal, direction);
    if (!(fabs(along) > error * largest3(fabs(direction)))) return true;
    const float side = along > 0.0f ? 1.0f : -1.0f;
    const float3 corner[3] = {triangle.v0 - origin, triangle.v1 - origin, triangle.v2 - origin};
    for (uint i = 0; i < 3; ++i)
        if (side * dot3(normal, corner[i]) > error * largest3(fabs(corner[i]))) return false;
    return true;
}

/* Whether the plane of a triangle, moved to the ray's origin, separates ray and triangle.
 * in_plane: of a triangle whose corners may also be in the plane. */
RSH_CALLED static bool separates(triangle_points of, rsh_ray ray, triangle_points triangle,
                                 bool in_plane)
{
    if (!may_separate(of, ray, triangle)) return false;
    const triangle_plane plane = plane_of(of);
    const float3 origin = ray.origin_tmin.xyz;
    const int ahead = side_ahead(&plane, ray.direction_tmax.xyz);
    const int farthest = in_plane ? 0 : -1;
    return ahead != 0 && ahead * side_of(&plane, origin, triangle.v0) <= farthest &&
           ahead * side_of(&plane, origin, triangle.v1) <= farthest &&
           ahead * side_of(&plane, origin, triangle.v2) <= farthest;
}

/* Whether the hit of a ray is none. */
RSH_CALLED static bool is_separated(const triangles_left* left, uint ray, triangle_points hit)
{
    triangle_points from;
    return separates(hit, left->rays[ray], hit, false) ||
           (load_triangle_left_by(left, ray, &from) &&
            separates(from, left->rays[ray], hit, true));
}

static float triangle_extent(triangle_points p)
{
    return largest3(fmax(p.v0, fmax(p.v1, p.v2)) - fmin(p.v0, fmin(p.v1, p.v2)));
}

#endif
