/* intersect.h - the ray-triangle test that defines what a hit is, for every engine.
 *
 * Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013: move the ray's
 * origin to 0, shear space so that the ray becomes the axis of its largest direction component,
 * and look at the triangle in the plane across it. In that plane the ray is the point 0, and
 * the edge values  U = C x B,  V = A x C,  W = B x A  are twice the areas that 0 makes with the
 * edges: 0 is inside when none of them differs in sign.
 *
 * Two triangles that share an edge compute its value from the same four numbers, in the same
 * order or with the factors swapped. difference_of_products errs by at most 1.5 ulp, so its sign
 * is exact and it is 0 only for a true 0: the ray passes on one side for one triangle and on the
 * other for its neighbour, or on the edge (a hit) for both. No crack, also at vertices; no
 * double-precision fallback.
 *
 * Corners are taken in the order of mesh/corner_order.h, so that coincident triangles have the same
 * t, and are hit or not together, in whatever order their corners come.
 *
 * Triangles far from unit size are scaled, in that plane, by a power of two: exact, and the
 * products neither overflow nor drown, whatever the scene's unit. Shearing at most doubles the
 * size, so that a ray that hits sees corners no farther away than 2^22; products that overflow
 * belong to rays far outside, and end in NaN, a miss. A product that underflows errs by 2^-126
 * (flushed or denormal; monotonically, so signs are never reversed, but 0 may come of it): with
 * at least 2^-102 of area, a weight errs by 3 * 2^-24, three such errors of an edge value, where a
 * device flushes. Thinner triangles, less than 2^-62 of their size squared, are seen edge-on.
 *
 * What rounding does (u = 2^-24, |.| the largest component of vertex - origin, quotients 2.5 ulp =
 * 5u off; docs/numerics.md in full):
 *   across  a coordinate dx - slope * dz: dx u, dz u, slope 5u, product u, difference 2u as it is
 *           below 2 |.|: at most 10u |.|, below 11u with the products of errors; on two axes
 *           sqrt(2) 11u. So a reported hit is an exact hit of a triangle whose corners moved by
 *           no more than that, sideways.
 *   depth   a mean of the corners' depths, whose weights are edge values of one sign. These err by
 *           2u of themselves (Jeannerod, Louvet, Muller, Math. Comp. 82, 2013), which moves a mean
 *           by 2u |.| at most; then their sum 2u, its reciprocal 5u, a weight u, a corner's depth u,
 *           its product u, two sums 2u; for t the direction's reciprocal 5u, the product u:
 *           at most 20u |.|.
 * Together a hit is within 31u |.| of a point of the triangle on each axis, and within
 * sqrt(20^2 + 2 * 30^2) u, 47u |.|, in space: what boxes, cones and spheres have room for. Where
 * division is correctly rounded it is 6u, 12u, 18u and 29u.
 */
#ifndef RSH_MESH_INTERSECT_H
#define RSH_MESH_INTERSECT_H

#include "mesh/corner_order.h"
#include "mesh/filter.h"

#ifndef RSH_ALL_HITS
#define RSH_ALL_HITS 0 /* 1: a program for all hits of a ray */
#endif

/* Rays, sheared. kz: axis of the largest direction component; x, y: the next two,
 * cyclically. */
typedef struct sheared_rays {
    floatv origin_x, origin_y, origin_z; /* world axes */
    intv kz_is_x, kz_is_y;               /* masks; neither: z */
    floatv slope_x, slope_y, inverse_z;
    floatv tmin, tmax;
} sheared_rays;

/* Hits of rays with triangles, a lane each. */
typedef struct lane_hits {
    intv is_hit;         /* mask */
    floatv t, weight[3]; /* of the corners in their order, see mesh/corner_order.h */
#if RSH_ALL_HITS
    intv is_crossed; /* mask: hits, and others that only t leaves out */
#endif
#if RSH_FILTER
    intv is_negative; /* mask: the area */
#endif
} lane_hits;

/* The closest hits of some rays so far, a lane each. */
typedef struct closest_hits {
    floatv t, u, v;
    uintv primitive;
} closest_hits;

static floatv pick_x(sheared_rays r, floatv x, floatv y, floatv z)
{
    return select(select(x, z, r.kz_is_y), y, r.kz_is_x);
}
static floatv pick_y(sheared_rays r, floatv x, floatv y, floatv z)
{
    return select(select(y, x, r.kz_is_y), z, r.kz_is_x);
}
static floatv pick_z(sheared_rays r, floatv x, floatv y, floatv z)
{
    return select(select(z, y, r.kz_is_y), x, r.kz_is_x);
}

/* tmin is raised to 0 and tmax lowered to the largest float: nothing behind the origin, no t
 * that overflowed. A t that underflows to 0 could still lie behind: its sign is tested
 * before. */
static sheared_rays shear_rays(floatv origin_x, floatv origin_y, floatv origin_z, floatv x,
                               floatv y, floatv z, floatv tmin, floatv tmax)
{
    sheared_rays r;
    r.origin_x = origin_x;
    r.origin_y = origin_y;
    r.origin_z = origin_z;
    r.kz_is_x = (fabs(x) > fabs(y)) & (fabs(x) > fabs(z));
    r.kz_is_y = (fabs(y) >= fabs(x)) & (fabs(y) > fabs(z));
    const floatv kz = pick_z(r, x, y, z);
    r.slope_x = pick_x(r, x, y, z) / kz;
    r.slope_y = pick_y(r, x, y, z) / kz;
    r.inverse_z = (floatv)(1.0f) / kz;
    r.tmin = fmax(tmin, (floatv)(0.0f));
    r.tmax = fmin(tmax, (floatv)(FLT_MAX));
    return r;
}

/* a*b - c*d within 1.5 ulp (Kahan): `error` is the rounding of c*d, exactly. */
static floatv difference_of_products(floatv a, floatv b, floatv c, floatv d)
{
    const floatv cd = c * d;
    const floatv error = fma(-c, d, cd);
    return fma(a, b, -cd) + error;
}

/* One corner in ray space: x and y across the ray, z along it. */
#define SHEAR_CORNER(r, px, py, pz, ax, ay, az)        \
    do {                                               \
        const floatv dx = (px) - (r).origin_x;         \
        const floatv dy = (py) - (r).origin_y;         \
        const floatv dz = (pz) - (r).origin_z;         \
        az = pick_z(r, dx, dy, dz);                    \
        ax = pick_x(r, dx, dy, dz) - (r).slope_x * az; \
        ay = pick_y(r, dx, dy, dz) - (r).slope_y * az; \
    } while (0)

/* Corners of triangles in ray space: x and y across the ray, z along it. */
typedef struct ray_space_corners {
    floatv ax, ay, az, bx, by, bz, cx, cy, cz;
} ray_space_corners;

static ray_space_corners to_ray_space(sheared_rays r, const floatv* corner)
{
    ray_space_corners s;
    SHEAR_CORNER(r, corner[0], corner[1], corner[2], s.ax, s.ay, s.az);
    SHEAR_CORNER(r, corner[3], corner[4], corner[5], s.bx, s.by, s.bz);
    SHEAR_CORNER(r, corner[6], corner[7], corner[8], s.cx, s.cy, s.cz);
    return s;
}

/* 1 for triangles of 2^-20 to 2^20 in size, the larger component of two edges; otherwise the
 * power of two that brings the size to 1 .. 2; from the exponent's bits, kept away from those
 * of 0 and infinity. */
static floatv triangle_scale(const floatv* corner)
{
    floatv size = (floatv)(0.0f);
    for (int axis = 0; axis < 3; ++axis)
        size = fmax(size, fmax(fabs(corner[3 + axis] - corner[axis]),
                               fabs(corner[6 + axis] - corner[axis])));
    const intv exponent = as_intv(size) & 0x7f800000;
    const floatv power = as_floatv(0x7f000000 - min(exponent, (intv)(0x7e800000)));
    const intv is_usual = (size >= (floatv)(0x1p-20f)) & (size <= (floatv)(0x1p20f));
    return select(power, (floatv)(1.0f), is_usual);
}

/* Scales the plane across the ray: all edge values and the area alike. */
static void scale_across(ray_space_corners* s, floatv scale)
{
    s->ax *= scale;
    s->ay *= scale;
    s->bx *= scale;
    s->by *= scale;
    s->cx *= scale;
    s->cy *= scale;
}

/* t and weights; and hits are only those from tmin to tmax. edge: U, V, W; area: their sum. */
static void place_hits(sheared_rays r, const ray_space_corners* s, const floatv* edge,
                       floatv area, lane_hits* hits)
{
    const floatv zero = (floatv)(0.0f);
    const floatv inverse = (floatv)(1.0f) / area;
    /* Not a loop: compilers unroll it too late to keep the weights in registers. */
    hits->weight[0] = edge[0] * inverse;
    hits->weight[1] = edge[1] * inverse;
    hits->weight[2] = edge[2] * inverse;
    const floatv depth =
        hits->weight[0] * s->az + hits->weight[1] * s->bz + hits->weight[2] * s->cz;
    const intv is_ahead =
        ((depth >= zero) & (r.inverse_z > zero)) | ((depth <= zero) & (r.inverse_z < zero));
    hits->t = depth * r.inverse_z;
    hits->is_hit &= is_ahead & (hits->t >= r.tmin) & (hits->t <= r.tmax);
#if RSH_FILTER
    hits->is_negative = area < zero;
#endif
}

/* Which of the rays' lines pass through their triangles, a mask; edge, area: see place_hits. */
static intv find_crossed(const ray_space_corners* s, floatv* edge, floatv* area)
{
    const floatv U = difference_of_products(s->cx, s->by, s->cy, s->bx);
    const floatv V = difference_of_products(s->ax, s->cy, s->ay, s->cx);
    const floatv W = difference_of_products(s->bx, s->ay, s->by, s->ax);
    const floatv zero = (floatv)(0.0f);
    edge[0] = U, edge[1] = V, edge[2] = W;
    *area = U + V + W;
    return (((U >= zero) & (V >= zero) & (W >= zero)) |
            ((U <= zero) & (V <= zero) & (W <= zero))) &
           (fabs(*area) >= (floatv)(0x1p-102f));
}

/* Where the rays hit triangles that are in ray space, scaled. NaN anywhere ends in a miss. */
static lane_hits intersect_sheared(sheared_rays r, ray_space_corners s)
{
    lane_hits hits;
    floatv edge[3], area;
    hits.is_hit = find_crossed(&s, edge, &area);
    hits.t = hits.weight[0] = hits.weight[1] = hits.weight[2] = (floatv)(0.0f);
#if RSH_WIDTH > 1
    /* Across work-items it saves nothing unless all of them leave; and Intel's CPU runtime
     * (2026.22) then lost a hit of the ones that stay. */
    if (!any_lane(hits.is_hit)) return hits;
#endif
    place_hits(r, &s, edge, area, &hits);
    return hits;
}

/* The same without a branch. Where about every other line passes through a triangle, as in a leaf whose
 * box the ray meets, a CPU guesses wrong too often. Of lanes that miss, t and weights mean nothing. */
static lane_hits intersect_unbranched(sheared_rays r, ray_space_corners s)
{
    lane_hits hits;
    floatv edge[3], area;
    hits.is_hit = find_crossed(&s, edge, &area);
    place_hits(r, &s, edge, area, &hits);
    return hits;
}

/* corner[3 * i + axis], in order: one triangle per lane, or one for all. */
static lane_hits intersect(sheared_rays r, const floatv* corner)
{
    ray_space_corners sheared = to_ray_space(r, corner);
    scale_across(&sheared, triangle_scale(corner));
    return intersect_sheared(r, sheared);
}

static closest_hits no_hits(void)
{
    return (closest_hits){(floatv)(0.0f), (floatv)(0.0f), (floatv)(0.0f), (uintv)(RSH_NO_HIT)};
}

/* Triangles come in ascending order, so of equal t the first one stays. places: of its corners. */
static void keep_closer(closest_hits* best, lane_hits hits, uint triangle, uint places)
{
    const intv is_better =
        hits.is_hit & ((hits.t < best->t) | (best->primitive == (uintv)(RSH_NO_HIT)));
    if (!any_lane(is_better)) return;
    best->t = select(best->t, hits.t, is_better);
    best->u = select(best->u, weight_of_corner(hits.weight, 1, places), is_better);
    best->v = select(best->v, weight_of_corner(hits.weight, 2, places), is_better);
    best->primitive = select(best->primitive, (uintv)(triangle), as_uintv(is_better));
}

/* The same triangle in every lane. */
static void broadcast_triangle(triangle_points triangle, floatv* corner)
{
    corner[0] = (floatv)(triangle.v0.x);
    corner[1] = (floatv)(triangle.v0.y);
    corner[2] = (floatv)(triangle.v0.z);
    corner[3] = (floatv)(triangle.v1.x);
    corner[4] = (floatv)(triangle.v1.y);
    corner[5] = (floatv)(triangle.v1.z);
    corner[6] = (floatv)(triangle.v2.x);
    corner[7] = (floatv)(triangle.v2.y);
    corner[8] = (floatv)(triangle.v2.z);
}

/* One ray with one triangle, by the same instructions: every lane holds the same. */
static bool intersect_one(rsh_ray ray, triangle_points triangle, rsh_hit* hit)
{
    const sheared_rays r =
        shear_rays((floatv)(ray.origin_tmin.x), (floatv)(ray.origin_tmin.y),
                   (floatv)(ray.origin_tmin.z), (floatv)(ray.direction_tmax.x),
                   (floatv)(ray.direction_tmax.y), (floatv)(ray.direction_tmax.z),
                   (floatv)(ray.origin_tmin.w), (floatv)(ray.direction_tmax.w));
    const uint places = put_in_order(&triangle);
    floatv corner[9];
    broadcast_triangle(triangle, corner);
    const lane_hits hits = intersect(r, corner);
    float lanes[3 * RSH_WIDTH];
    int is_hit[RSH_WIDTH];
    store_lanes(hits.t, lanes);
    store_lanes(weight_of_corner(hits.weight, 1, places), lanes + RSH_WIDTH);
    store_lanes(weight_of_corner(hits.weight, 2, places), lanes + 2 * RSH_WIDTH);
    store_lanes(hits.is_hit, is_hit);
    hit->t = lanes[0];
    hit->u = lanes[RSH_WIDTH];
    hit->v = lanes[2 * RSH_WIDTH];
    return is_hit[0] != 0;
}

#endif
