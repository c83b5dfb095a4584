/* grazing.h - how flat over a surface rays leave. */
#ifndef RSH_SURFACE_GRAZING_H
#define RSH_SURFACE_GRAZING_H

#include "mesh/algebra_lanes.h"

/* The cosine between surface and ray below which "moves away" could be rounding; see
 * mesh/leaving.h. */
#define RSH_GRAZING 0x1p-16f

/* Unit directions that lead to `side`. One that does not, because the normal that it was
 * computed with is not the triangle's, is mirrored in the triangle's plane, as if it met the
 * surface twice. */
static float3v keep_on_side(float3v direction, float3v side)
{
    const floatv least = (floatv)(RSH_GRAZING), cosine = dot_v(direction, side);
    const intv is_kept = cosine >= least;
    const float3v up = scaled_v(fmax(-cosine, least) - cosine, side);
    return select_v(unit_v(sum_v(direction, up)), direction, is_kept);
}

#endif
