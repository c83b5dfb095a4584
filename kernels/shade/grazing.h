/* grazing.h - how flat over a surface rays leave. */
#ifndef RSH_SHADE_GRAZING_H
#define RSH_SHADE_GRAZING_H

#include "mesh/algebra.h"

/* The cosine between surface and ray below which "moves away" could be rounding; see
 * mesh/leaving.h. */
#define RSH_GRAZING 0x1p-16f

/* A unit direction that leads to `side`. One that does not, because the normal that it was
 * computed with is not the triangle's, is mirrored in the triangle's plane, as if it met the
 * surface twice. */
static float3 keep_on_side(float3 direction, float3 side)
{
    const float cosine = dot3(direction, side);
    if (cosine >= RSH_GRAZING) return direction;
    return unit3(direction + (fmax(-cosine, RSH_GRAZING) - cosine) * side);
}

#endif
