/* crossing.h - which triangles a ray crosses, where all of its hits count and not only the closest.
 *
 * A ray that meets an edge hits both triangles there, as mesh/intersect.h has it: right for the
 * closest hit, wrong for a count. Here the ray is moved, in the plane across it, from 0 to (e, e^2),
 * where e is smaller than any number there, and so meets no edge and no corner (simulation of
 * simplicity: Edelsbrunner and Muecke, ACM Transactions on Graphics 9(1), 1990). The edge value of
 * corners P and Q becomes
 *   Px Qy - Py Qx + e (Py - Qy) + e^2 (Qx - Px)
 * and its sign is that of the first term that is not 0. A triangle is crossed where its three signs
 * are the same. All triangles see the same corners moved by the same vector, so that a closed surface
 * is crossed an even number of times, needles and triangles seen edge-on included: if all three terms
 * of a sum of edges are 0, the area is, and the triangle is not crossed.
 *
 * Signs are exact. Where the edge values of mesh/intersect.h are 2^-100 or more, rounding has left
 * their sign alone: products that underflow err by 2^-126 each, and a corner that underflows when it
 * is scaled shifts a product by 2^-126 times 2^22, the most that a corner of a triangle that is hit
 * can have. Below that, a lane is decided on the corners before scaling, in integers.
 *
 * t is that of mesh/intersect.h, the same bits. Weights that underflow has left with the wrong sign
 * count as 0; and a triangle whose area, as it is seen, is below 2^-102 is taken for the longest side
 * of it: less than 2^-60 of that side lies beside it, so that the hit is within the same bounds.
 */
#ifndef RSH_MESH_CROSSING_H
#define RSH_MESH_CROSSING_H

#include "mesh/intersect.h"

#ifndef RSH_ALL_HITS
#define RSH_ALL_HITS 0 /* 1: a program for all hits of a ray */
#endif

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

/* The lanes of corners as triangles, one by one. */
typedef struct corner_lanes {
    float x[3][RSH_WIDTH], y[3][RSH_WIDTH];
} corner_lanes;

static corner_lanes store_corners(const ray_space_corners* s)
{
    corner_lanes lanes;
    store_lanes(s->ax, lanes.x[0]);
    store_lanes(s->bx, lanes.x[1]);
    store_lanes(s->cx, lanes.x[2]);
    store_lanes(s->ay, lanes.y[0]);
    store_lanes(s->by, lanes.y[1]);
    store_lanes(s->cy, lanes.y[2]);
    return lanes;
}

static flat_triangle triangle_of_lane(const corner_lanes* lanes, uint lane)
{
    flat_triangle at;
    for (uint i = 0; i < 3; ++i) {
        at.x[i] = lanes->x[i][lane];
        at.y[i] = lanes->y[i][lane];
    }
    return at;
}

/* Which of these lanes, a bit each, are crossed. */
static uint lanes_crossed(const ray_space_corners* s, uint doubtful)
{
    const corner_lanes lanes = store_corners(s);
    uint crossed = 0;
    for (; doubtful; doubtful &= doubtful - 1) {
        const uint k = 31 - clz(doubtful & -doubtful);
        const flat_triangle at = triangle_of_lane(&lanes, k);
        if (is_crossed(&at)) crossed |= 1u << k;
    }
    return crossed;
}

/* Gives the weights of a side to these lanes, a bit each. */
static void set_weights_on_side(const ray_space_corners* s, uint slim, floatv* weight)
{
    const corner_lanes lanes = store_corners(s);
    for (; slim; slim &= slim - 1) {
        const uint k = 31 - clz(slim & -slim);
        const flat_triangle at = triangle_of_lane(&lanes, k);
        float of[3];
        weights_on_side(&at, of);
        for (uint i = 0; i < 3; ++i) ((float*)&weight[i])[k] = of[i];
    }
}

/* An edge value whose sign is not that of the area counts as 0. */
static floatv with_sign(floatv edge, intv is_positive)
{
    const floatv zero = (floatv)(0.0f);
    return select(fmin(edge, zero), fmax(edge, zero), is_positive);
}

/* t and weights of crossed triangles; edge: U, V, W of mesh/intersect.h, of the scaled triangle. */
static void place_hits(sheared_rays r, const ray_space_corners* s, const floatv* edge,
                       lane_hits* hits)
{
    const floatv zero = (floatv)(0.0f);
    const intv is_positive = edge[0] + edge[1] + edge[2] > zero;
    const floatv U = with_sign(edge[0], is_positive), V = with_sign(edge[1], is_positive),
                 W = with_sign(edge[2], is_positive);
    const floatv area = U + V + W, inverse = (floatv)(1.0f) / area;
    hits->weight[0] = U * inverse;
    hits->weight[1] = V * inverse;
    hits->weight[2] = W * inverse;
    const uint slim = RSH_LANE_BITS(hits->is_hit & (fabs(area) < (floatv)(0x1p-102f)));
    if (slim) set_weights_on_side(s, slim, hits->weight);
    const floatv depth =
        hits->weight[0] * s->az + hits->weight[1] * s->bz + hits->weight[2] * s->cz;
    const intv is_ahead =
        ((depth >= zero) & (r.inverse_z > zero)) | ((depth <= zero) & (r.inverse_z < zero));
    hits->t = depth * r.inverse_z;
    hits->is_hit &= is_ahead & (hits->t >= r.tmin) & (hits->t <= r.tmax);
}

/* Where the rays cross triangles that are in ray space, not scaled yet; scale: theirs. */
static lane_hits cross_sheared(sheared_rays r, ray_space_corners s, floatv scale)
{
    lane_hits hits;
    ray_space_corners scaled = s;
    scale_across(&scaled, scale);
    const floatv edge[3] = {difference_of_products(scaled.cx, scaled.by, scaled.cy, scaled.bx),
                            difference_of_products(scaled.ax, scaled.cy, scaled.ay, scaled.cx),
                            difference_of_products(scaled.bx, scaled.ay, scaled.by, scaled.ax)};
    const floatv sure = (floatv)(RSH_SURE_EDGE);
    hits.is_hit = ((edge[0] >= -sure) & (edge[1] >= -sure) & (edge[2] >= -sure)) |
                  ((edge[0] <= sure) & (edge[1] <= sure) & (edge[2] <= sure));
    hits.t = hits.weight[0] = hits.weight[1] = hits.weight[2] = (floatv)(0.0f);
    if (!any_lane(hits.is_hit)) return hits;
    const uint doubtful =
        RSH_LANE_BITS(hits.is_hit & ((fabs(edge[0]) < sure) | (fabs(edge[1]) < sure) |
                                     (fabs(edge[2]) < sure)));
    if (doubtful) hits.is_hit &= ~mask_of_bits(doubtful & ~lanes_crossed(&s, doubtful));
    place_hits(r, &s, edge, &hits);
    return hits;
}

/* As `intersect` of mesh/intersect.h. */
static lane_hits cross_triangles(sheared_rays r, const floatv* corner)
{
    return cross_sheared(r, to_ray_space(r, corner), triangle_scale(corner));
}

#endif

#endif
