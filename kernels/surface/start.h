/* start.h - the floats that rays start at, of those around a point that surface/departure.h found. */
#ifndef RSH_SURFACE_START_H
#define RSH_SURFACE_START_H

#include "surface/departure.h"

/* The floats next to v, towards the signs of `way`. */
static floatv next_floats(floatv v, floatv way)
{
    const floatv zero = (floatv)(0.0f);
    const intv inwards = (v < zero) != (way < zero);
    const floatv next = as_floatv(as_intv(v) + select((intv)(1), (intv)(-1), inwards));
    return select(next, copysign((floatv)(0x1p-126f), way), v == zero);
}

static floatv rounded_up_on_axis(floatv high, floatv low, floatv side)
{
    return select(high, next_floats(high, side), low * side > (floatv)(0.0f));
}

/* The float that is farther to the side on each axis: within an ulp, and quicker, for rays that no
 * other one follows. */
static float3v rounded_up(twofold3v start, float3v side)
{
    return (float3v){rounded_up_on_axis(start.high.x, start.low.x, side.x),
                     rounded_up_on_axis(start.high.y, start.low.y, side.y),
                     rounded_up_on_axis(start.high.z, start.low.z, side.z)};
}

/* How far ahead of the point, in 2^-24 of its largest coordinate, and what an error along the ray
 * counts beside one across it, squared. With 0 and 1 the error at the 11th of a chain of mirrors
 * is 2.2 times that of rounding to nearest, with these 1.2 times; the first origin's is 1.6
 * times, instead of 1.4. */
#define RSH_PLACE_AHEAD 0.75f
#define RSH_ALONG_SHARE 0.25f

/* A value of each of the eight floats around a point, the sum of one per axis: bit i of a float's
 * number is its choice on axis i. */
typedef struct choices {
    floatv of[8];
} choices;

static choices sums_of_choices(float3v first, float3v second)
{
    const floatv xy[4] = {first.x + first.y, second.x + first.y, first.x + second.y,
                          second.x + second.y};
    choices sums;
    for (uint i = 0; i < 4; ++i) {
        sums.of[i] = xy[i] + first.z;
        sums.of[i + 4] = xy[i] + second.z;
    }
    return sums;
}

/* On which axes the float with the least value is the second one. Of equal ones, the first on z, then
 * y, then x. */
typedef struct chosen {
    intv x, y, z; /* masks */
} chosen;

static chosen least_of(choices values)
{
    intv z[4], y[2];
    for (uint i = 0; i < 4; ++i) {
        z[i] = values.of[i + 4] < values.of[i];
        values.of[i] = select(values.of[i], values.of[i + 4], z[i]);
    }
    for (uint i = 0; i < 2; ++i) {
        y[i] = values.of[i + 2] < values.of[i];
        values.of[i] = select(values.of[i], values.of[i + 2], y[i]);
        z[i] = select(z[i], z[i + 2], y[i]);
    }
    const intv x = values.of[1] < values.of[0];
    return (chosen){x, select(y[0], y[1], x), select(z[0], z[1], x)};
}

/* How bad each of the eight floats is as a start; infinite: it may be on the wrong side. first,
 * second: from the place to the floats on each axis, scaled to some ulp. */
static choices badness_of(float3v first, float3v second, float3v side, float3v direction)
{
    const choices along =
        sums_of_choices(product_v(first, direction), product_v(second, direction));
    const float3v up = product_v(first, side), up2 = product_v(second, side);
    const choices height = sums_of_choices(up, up2);
    const choices sizes = sums_of_choices(fabs_v(up), fabs_v(up2));
    choices badness = sums_of_choices(product_v(first, first), product_v(second, second));
    for (uint i = 0; i < 8; ++i) {
        const floatv bad = badness.of[i] - (1.0f - RSH_ALONG_SHARE) * along.of[i] * along.of[i];
        badness.of[i] = select(bad, (floatv)(INFINITY), height.of[i] < 0x1p-21f * sizes.of[i]);
    }
    return badness;
}

/* One of the eight floats around a place just ahead of the point. One of them is on the side,
 * if `direction` leads there by RSH_GRAZING: so is the place, and the float that is farther to
 * that side on each axis. */
static float3v rounded_to_side(twofold3v point, float3v side, float3v direction)
{
    const floatv step = RSH_PLACE_AHEAD * 0x1p-24f * largest_v(fabs_v(point.high));
    const float3v ahead = scaled_v(step, direction);
    const twofold3v place = gathered_v(point.high, sum_v(point.low, ahead));
    const float3v next = {next_floats(place.high.x, place.low.x),
                          next_floats(place.high.y, place.low.y),
                          next_floats(place.high.z, place.low.z)};
    const floatv scale = scale_to_one_v(largest_v(fabs_v(place.high)));
    const float3v first = scaled_v(scale, minus_v(ahead, place.low));
    const float3v second =
        scaled_v(scale, sum_v(minus_v(minus_v(next, place.high), place.low), ahead));
    const chosen is_next = least_of(badness_of(first, second, side, direction));
    return (float3v){select(place.high.x, next.x, is_next.x),
                     select(place.high.y, next.y, is_next.y),
                     select(place.high.z, next.z, is_next.z)};
}

#endif
