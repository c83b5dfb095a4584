/* crossing.h - which triangles a ray crosses, where all of its hits count and not only the closest.
 *
 * A ray that meets an edge hits both triangles there, as mesh/intersect.h has it: right for the
 * closest hit, wrong for a count. Here the ray is moved, in the plane across it, from 0 to (e, e^2),
 * where e is smaller than any number there, and so meets no edge and no corner (simulation of
 * simplicity: Edelsbrunner and Muecke, ACM Transactions on Graphics 9(1), 1990). The edge value of
 * corners P and Q becomes
 *   Px Qy - Py Qx + e (Py - Qy) + e^2 (Qx - Px)
 * and its sign is that of the first term that is not 0. A triangle is crossed where its three signs
 * are the same. All triangles see the same corners moved by the same vector, so that the line of a ray
 * crosses a closed surface an even number of times, through needles as well. A triangle seen edge-on has
 * edge values that add up to 0, and is never crossed.
 *
 * Signs are exact: edge values above 2^-100 have theirs from mesh/intersect.h, and below that a
 * lane is decided on the corners before scaling, in integers (docs/numerics.md, Lemma 11).
 *
 * t is that of mesh/intersect.h, the same bits. Weights that underflow has left with the wrong sign
 * count as 0; and a triangle whose area, as it is seen, is below 2^-102 is taken for the longest side
 * of it: nothing of it is farther from there than 2^-31 of its size, so that the hit is within the
 * same bounds.
 */
#ifndef RSH_MESH_CROSSING_H
#define RSH_MESH_CROSSING_H

#include "mesh/intersect.h"

#if RSH_ALL_HITS

#define RSH_SURE_EDGE 0x1p-100f

/* A triangle in the plane across a ray. */
typedef struct flat_triangle {
    float x[3], y[3];
} flat_triangle;

static bool is_zero(float v) { return (as_uint(v) & 0x7fffffffu) == 0; }

/* In the order of the numbers: also of denormals, which a device may take for 0 in floats. */
static int ordered(float v)
{
    const int bits = as_int(v);
    return bits >= 0 ? bits : (int)0x80000000 - bits;
}

static int sign_of_step(float from, float to)
{
    return ordered(from) > ordered(to) ? -1 : ordered(from) < ordered(to) ? 1 : 0;
}

/* |a b|, exactly: mantissa 2^exponent, the mantissa's highest bit set. */
typedef struct exact_product {
    ulong mantissa;
    int exponent;
} exact_product;

static exact_product product_of(float a, float b)
{
    const uint p = as_uint(a), q = as_uint(b);
    const int above = max((int)(p >> 23 & 255), 1), beside = max((int)(q >> 23 & 255), 1);
    const ulong of_a = (p & 0x7fffffu) | (p >> 23 & 255 ? 0x800000u : 0);
    const ulong of_b = (q & 0x7fffffu) | (q >> 23 & 255 ? 0x800000u : 0);
    const ulong product = of_a * of_b;
    const int shift = (int)clz(product);
    return (exact_product){product << shift, above + beside - shift};
}

static int sign_of_product(float a, float b)
{
    if (is_zero(a) || is_zero(b)) return 0;
    return (as_int(a) ^ as_int(b)) < 0 ? -1 : 1;
}

/* Of a b - c d. */
static int sign_of_difference(float a, float b, float c, float d)
{
    const int first = sign_of_product(a, b), second = sign_of_product(c, d);
    if (first != second || first == 0) return first > second ? 1 : first < second ? -1 : 0;
    const exact_product p = product_of(a, b), q = product_of(c, d);
    if (p.exponent != q.exponent) return p.exponent > q.exponent ? first : -first;
    return p.mantissa > q.mantissa ? first : p.mantissa < q.mantissa ? -first : 0;
}

/* Of the edge value of corners p and q, seen from the ray that was moved. */
static int sign_of_edge(const flat_triangle* at, uint p, uint q)
{
    const int sign = sign_of_difference(at->x[p], at->y[q], at->y[p], at->x[q]);
    if (sign) return sign;
    const int step = sign_of_step(at->y[q], at->y[p]);
    return step ? step : sign_of_step(at->x[p], at->x[q]);
}

static bool is_crossed(const flat_triangle* at)
{
    const int sign = sign_of_edge(at, 2, 1);
    return sign != 0 && sign_of_edge(at, 0, 2) == sign && sign_of_edge(at, 1, 0) == sign;
}

/* Weights of the corners where the ray meets the longest side. */
static void weights_on_side(const flat_triangle* at, float* weight)
{
    float low[2], high[2];
    for (uint k = 0; k < 2; ++k) {
        const float* c = k ? at->y : at->x;
        low[k] = fmin(c[0], fmin(c[1], c[2]));
        high[k] = fmax(c[0], fmax(c[1], c[2]));
    }
    const uint axis = high[1] - low[1] > high[0] - low[0];
    const float* c = axis ? at->y : at->x;
    uint first = 0, last = 0;
    for (uint k = 1; k < 3; ++k) {
        if (c[k] < c[first]) first = k;
        if (c[k] > c[last]) last = k;
    }
    const float length = c[last] - c[first];
    weight[0] = weight[1] = weight[2] = 0.0f;
    weight[last] = length > 0.0f ? -c[first] / length : 0.0f;
    weight[first] += 1.0f - weight[last];
}

static flat_triangle triangle_of_lane(const ray_space_corners* s, uint lane)
{
    const floatv* const x[3] = {&s->ax, &s->bx, &s->cx};
    const floatv* const y[3] = {&s->ay, &s->by, &s->cy};
    flat_triangle at;
    for (uint i = 0; i < 3; ++i) {
        at.x[i] = ((const float*)x[i])[lane];
        at.y[i] = ((const float*)y[i])[lane];
    }
    return at;
}

#if RSH_FILTER
/* Gives the area of edge values the sign of the crossing; their weights stay the same bits. */
static void turn_edges(const flat_triangle* at, float* edge)
{
    if ((sign_of_edge(at, 2, 1) < 0) == (edge[0] + edge[1] + edge[2] < 0.0f)) return;
    for (uint i = 0; i < 3; ++i) edge[i] = -edge[i];
}
#endif

/* Decides one lane on its corners before scaling, and gives it edge values that place the hit. */
static bool settle_lane(const flat_triangle* at, float* edge)
{
    if (!is_crossed(at)) return false;
    const bool is_positive = edge[0] + edge[1] + edge[2] > 0.0f;
    float area = 0.0f;
    for (uint i = 0; i < 3; ++i) {
        edge[i] = is_positive ? fmax(edge[i], 0.0f) : fmin(edge[i], 0.0f);
        area += edge[i];
    }
    if (!(fabs(area) >= 0x1p-102f)) weights_on_side(at, edge);
#if RSH_FILTER
    turn_edges(at, edge);
#endif
    return true;
}

/* Which of the doubtful lanes, a bit each, are crossed. */
static __attribute__((noinline)) uint settle_each(const ray_space_corners* s, uint doubtful,
                                                  floatv* edge)
{
    uint crossed = 0;
    for (; doubtful; doubtful &= doubtful - 1) {
        const uint k = 31 - clz(doubtful & -doubtful);
        const flat_triangle at = triangle_of_lane(s, k);
        float of[3];
        for (uint i = 0; i < 3; ++i) of[i] = ((const float*)&edge[i])[k];
        if (!settle_lane(&at, of)) continue;
        for (uint i = 0; i < 3; ++i) ((float*)&edge[i])[k] = of[i];
        crossed |= 1u << k;
    }
    return crossed;
}

/* The same. Few lanes are doubtful: only here need corners and edge values be in memory. */
static uint settle_lanes(const ray_space_corners* s, uint doubtful, floatv* edge)
{
    const ray_space_corners given = *s;
    floatv of[3] = {edge[0], edge[1], edge[2]};
    const uint crossed = settle_each(&given, doubtful, of);
    edge[0] = of[0], edge[1] = of[1], edge[2] = of[2];
    return crossed;
}

/* Which of the rays' lines cross their triangles, a mask; edge: U, V, W. given: the triangles before
 * scaling. */
static intv find_crossings(const ray_space_corners* s, const ray_space_corners* given,
                           floatv* edge)
{
    const floatv sure = (floatv)(RSH_SURE_EDGE);
    edge[0] = difference_of_products(s->cx, s->by, s->cy, s->bx);
    edge[1] = difference_of_products(s->ax, s->cy, s->ay, s->cx);
    edge[2] = difference_of_products(s->bx, s->ay, s->by, s->ax);
    const intv may_be = ((edge[0] >= -sure) & (edge[1] >= -sure) & (edge[2] >= -sure)) |
                        ((edge[0] <= sure) & (edge[1] <= sure) & (edge[2] <= sure));
    const uint doubtful = RSH_LANE_BITS(
        may_be & ((fabs(edge[0]) <= sure) | (fabs(edge[1]) <= sure) | (fabs(edge[2]) <= sure)));
    if (!doubtful) return may_be;
    return may_be & ~mask_of_bits(doubtful & ~settle_lanes(given, doubtful, edge));
}

/* Where the rays cross triangles that are in ray space, scaled; given: the same before scaling. Without a
 * branch, see intersect_unbranched. */
static lane_hits cross_unbranched(sheared_rays r, ray_space_corners s,
                                  const ray_space_corners* given)
{
    lane_hits hits;
    floatv edge[3];
    hits.is_hit = hits.is_crossed = find_crossings(&s, given, edge);
    place_hits(r, &s, edge, edge[0] + edge[1] + edge[2], &hits);
    return hits;
}

static lane_hits cross_sheared(sheared_rays r, ray_space_corners s,
                               const ray_space_corners* given)
{
    lane_hits hits;
    floatv edge[3];
    hits.is_hit = hits.is_crossed = find_crossings(&s, given, edge);
    hits.t = hits.weight[0] = hits.weight[1] = hits.weight[2] = (floatv)(0.0f);
    if (!any_lane(hits.is_hit)) return hits;
    place_hits(r, &s, edge, edge[0] + edge[1] + edge[2], &hits);
    return hits;
}

/* As `intersect` of mesh/intersect.h. */
static lane_hits cross_triangles(sheared_rays r, const floatv* corner)
{
    const ray_space_corners given = to_ray_space(r, corner);
    ray_space_corners scaled = given;
    scale_across(&scaled, triangle_scale(corner));
    return cross_sheared(r, scaled, &given);
}

#endif

#endif
