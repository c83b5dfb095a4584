/* box_node.h - the node shape `box`: origins in one box, directions in another, 16 nodes side
 * by side; and the slab test, in interval arithmetic, of such nodes against boxes of the scene.
 *
 * A node stands for all rays o + t d with o in [origin_low, origin_high], d in [direction_low,
 * direction_high], 0 <= t <= tmax. It can meet the box [low, high] only if on every axis
 *   L <= t d <= H    with  L = low - origin_high,  H = high - origin_low
 * for one and the same t. By the signs of the directions:
 *   d > 0:  L / d_high <= t <= H / d_low      (for L < 0, H < 0 the bounds are loose, but have
 *   d < 0:  H / d_low  <= t <= L / d_high      the right sign, and t starts at 0: nothing lost)
 *   mixed:  t >= L / d_high if L > 0 (never if d_high <= 0), t >= H / d_low if H < 0
 * so that two differences and two products per axis do. A minimum or maximum is associative: a
 * parent is as tight as if it were fitted to all its rays.
 *
 * Rounding (u = 2^-24). What mesh/intersect.h reports as a hit at t lies, with the exact ray,
 * within 31u (|p| + |o|) of a point of the triangle on each axis, where |.| is the largest component
 * of its corners and of the ray's origin. The boxes of triangles are padded by 64u |p|, with the
 * largest |p| of their leaf, those of origins by 64u |o|. What remains, 33u (|p| + |o|), pays for
 * rounding the padded values, u each, and for the bounds: L and H err by u of themselves, which
 * their sign survives; reciprocals by 2.5 ulp = 5u, products by u: 7u of what is no more than
 * |p| + |o|. So bounds hold as they are; the far ones, and tmax, are raised by 2^-19 = 32u all the
 * same, at no cost. Overflow: L is infinite only if every corner is infinitely far from every
 * origin, which mesh/intersect.h takes for a miss. A reciprocal that overflows is lowered to
 * the largest float where it bounds from below. A product 0 * infinity says nothing:
 * comparisons drop NaN.
 */
#ifndef RSH_RAYS_BOX_NODE_H
#define RSH_RAYS_BOX_NODE_H

#include "mesh/boxes16.h"
#include "rays/ray_block.h"

#define RSH_RAISED (1.0f + 0x1p-19f)

/* Rows of box_node16: origin low, high, direction low, high (3 each), tmax,
 * is_converging. */
#define RSH_NODE_ROWS 14

/* One axis of a node, made ready for the test: near bounds t from below, far from above; with
 * mixed signs, far is a second bound from below. */
typedef struct axis_slab {
    float near_origin, near_inverse, far_origin, far_inverse;
    int sign; /* of all directions: 1 or -1; 0: mixed */
} axis_slab;

static axis_slab slab_of(float origin_low, float origin_high, float direction_low,
                         float direction_high)
{
    const float to_low = 1.0f / direction_low, to_high = 1.0f / direction_high;
    const float near_low = fmax(to_low, -FLT_MAX), near_high = fmin(to_high, FLT_MAX);
    if (direction_low > 0.0f)
        return (axis_slab){origin_high, near_high, origin_low, to_low * RSH_RAISED, 1};
    if (direction_high < 0.0f)
        return (axis_slab){origin_low, near_low, origin_high, to_high * RSH_RAISED, -1};
    return (axis_slab){origin_high, direction_high > 0.0f ? near_high : INFINITY, origin_low,
                       direction_low < 0.0f ? near_low : -INFINITY, 0};
}

/* One node, made ready to be tested against 16 boxes. */
typedef struct interval_packet {
    axis_slab slab[3];
    float limit; /* tmax of the farthest ray, raised; negative: nothing left to find */
} interval_packet;

/* Which of 16 boxes the packet can meet, a bit each. near, unless 0: from which t on. */
static uint boxes_met(const interval_packet* packet, const boxes16* boxes, float* near)
{
    uint met = 0;
    for_each_vector(v) {
        floatv from = (floatv)(0.0f), to = (floatv)(packet->limit);
        for (uint axis = 0; axis < 3; ++axis) {
            const axis_slab slab = packet->slab[axis];
            const floatv low = boxes->low[axis][v], high = boxes->high[axis][v];
            if (slab.sign > 0) {
                from = greater((low - slab.near_origin) * slab.near_inverse, from);
                to = lesser((high - slab.far_origin) * slab.far_inverse, to);
            } else if (slab.sign < 0) {
                from = greater((high - slab.near_origin) * slab.near_inverse, from);
                to = lesser((low - slab.far_origin) * slab.far_inverse, to);
            } else {
                from = greater((low - slab.near_origin) * slab.near_inverse, from);
                from = greater((high - slab.far_origin) * slab.far_inverse, from);
            }
        }
        if (near) store_lanes(from, near + RSH_WIDTH * v);
        met |= RSH_LANE_BITS(from <= to) << (RSH_WIDTH * v);
    }
    return met;
}

/* 16 nodes, made ready to be tested against one box. */
typedef struct interval_packet16 {
    floatv near_origin[3][RSH_VECTORS], near_inverse[3][RSH_VECTORS];
    floatv far_origin[3][RSH_VECTORS], far_inverse[3][RSH_VECTORS], far_offset[3][RSH_VECTORS];
    floatv other_origin[3][RSH_VECTORS], other_inverse[3][RSH_VECTORS]; /* mixed signs */
    intv is_negative[3][RSH_VECTORS];
    floatv limit[RSH_VECTORS];
} interval_packet16;

/* Which of the 16 packets can meet the box, a bit each. Bits mean nothing for packets that
 * `common` does not enclose: its signs decide how the others are tested. */
static uint packets_meeting(const interval_packet16* nodes, const interval_packet* common,
                            const float* low, const float* high)
{
    uint met = 0;
    for_each_vector(v) {
        floatv from = (floatv)(0.0f), to = nodes->limit[v];
        for (uint axis = 0; axis < 3; ++axis) {
            const floatv near_origin = nodes->near_origin[axis][v];
            const floatv near_inverse = nodes->near_inverse[axis][v];
            const floatv far_origin = nodes->far_origin[axis][v];
            const floatv far_inverse = nodes->far_inverse[axis][v];
            const int sign = common->slab[axis].sign;
            if (sign) {
                const float near = sign > 0 ? low[axis] : high[axis];
                const float far = sign > 0 ? high[axis] : low[axis];
                from = greater((near - near_origin) * near_inverse, from);
                to = lesser((far - far_origin) * far_inverse, to);
                continue;
            }
            const intv is_negative = nodes->is_negative[axis][v];
            const floatv near = select((floatv)(low[axis]), (floatv)(high[axis]), is_negative);
            const floatv far = select((floatv)(high[axis]), (floatv)(low[axis]), is_negative);
            from = greater((near - near_origin) * near_inverse, from);
            to = lesser(fma(far - far_origin, far_inverse, nodes->far_offset[axis][v]), to);
            from = greater((far - nodes->other_origin[axis][v]) * nodes->other_inverse[axis][v],
                           from);
        }
        met |= RSH_LANE_BITS(from <= to) << (RSH_WIDTH * v);
    }
    return met;
}

static void set_packets_axis(interval_packet16* nodes, uint axis, uint v, floatv origin_low,
                             floatv origin_high, floatv direction_low, floatv direction_high)
{
    const floatv zero = (floatv)(0.0f), infinite = (floatv)(INFINITY);
    const floatv to_low = (floatv)(1.0f) / direction_low;
    const floatv to_high = (floatv)(1.0f) / direction_high;
    const floatv near_low = greater(to_low, (floatv)(-FLT_MAX));
    const floatv near_high = lesser(to_high, (floatv)(FLT_MAX));
    const intv is_negative = direction_high < zero;
    const intv is_mixed = (direction_low <= zero) & (direction_high >= zero);
    nodes->is_negative[axis][v] = is_negative;
    nodes->near_origin[axis][v] = select(origin_high, origin_low, is_negative);
    nodes->near_inverse[axis][v] =
        select(select(near_high, infinite, direction_high <= zero), near_low, is_negative);
    nodes->far_origin[axis][v] = select(origin_low, origin_high, is_negative);
    nodes->far_inverse[axis][v] =
        select(select(to_low, to_high, is_negative) * RSH_RAISED, zero, is_mixed);
    nodes->far_offset[axis][v] = select(zero, infinite, is_mixed);
    nodes->other_origin[axis][v] = origin_low;
    nodes->other_inverse[axis][v] =
        select(zero, select(-infinite, near_low, direction_low < zero), is_mixed);
}

#endif
