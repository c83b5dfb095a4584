/* departure.h - where rays of a block that leave surfaces start, rounded up: shade/departure.h a
 * lane each, with the same bits; the reasons are there.
 */
#ifndef RSH_SHADE_LANES_DEPARTURE_H
#define RSH_SHADE_LANES_DEPARTURE_H

#include "shade/lanes/surface.h"

typedef struct departure_lanes {
    twofold3v normal;
    float3v direction, point, rest;
    floatv error;
} departure_lanes;

/* A mask: where not, the barycentric point is needed. */
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

static void take_barycentric_points(const surface_lanes* surface, const ray_lanes* block,
                                    intv is_kept, departure_lanes* from)
{
    const twofold3v point = exact_sum3_v(surface->v0, offset_from_v0(surface, block));
    from->point = select_v(point.high, from->point, is_kept);
    from->rest = select_v(point.low, from->rest, is_kept);
    from->error = select(0x1p-21f * surface->edges.extent, from->error, is_kept);
}

static departure_lanes departures_of(const surface_lanes* surface, const ray_lanes* block)
{
    departure_lanes from;
    const floatv scale = scale_to_one_v(largest_v(fabs_v(block->direction)));
    from.direction = scaled_v(scale, block->direction);
    from.normal = twofold_cross_v(surface->edges.edge1, surface->edges.edge2);
    const intv is_kept = find_points(surface, block, block->t / scale, &from);
    take_barycentric_points(surface, block, is_kept, &from);
    return from;
}

static floatv next_floats_v(floatv v, floatv way)
{
    const floatv zero = (floatv)(0.0f);
    const intv inwards = (v < zero) != (way < zero);
    const floatv next = as_floatv(as_intv(v) + select((intv)(1), (intv)(-1), inwards));
    return select(next, copysign((floatv)(0x1p-126f), way), v == zero);
}

static floatv rounded_up_on_axis(floatv high, floatv low, floatv side)
{
    return select(high, next_floats_v(high, side), low * side > (floatv)(0.0f));
}

/* As leave_surface, then the float that is farther to the side on each axis: within an ulp, and
 * quicker, for rays that no other one follows. */
static float3v rounded_starts(const surface_lanes* surface, const departure_lanes* from,
                              float3v side, bool is_skipped)
{
    const floatv off = (floatv)(is_skipped ? 0.0f : 0x1p-18f) * surface->edges.extent;
    const floatv margin = 2.0f * from->error + 0x1p-124f + off;
    const twofold3v point = exact_sum3_v(from->point, scaled_v(margin, side));
    const twofold3v start = gathered_v(point.high, sum_v(point.low, from->rest));
    return (float3v){rounded_up_on_axis(start.high.x, start.low.x, side.x),
                     rounded_up_on_axis(start.high.y, start.low.y, side.y),
                     rounded_up_on_axis(start.high.z, start.low.z, side.z)};
}

#endif
