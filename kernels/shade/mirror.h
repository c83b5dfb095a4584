/* mirror.h - the direction of a mirrored ray, rounded once: in a chain of curved mirrors every
 * error grows from bounce to bounce. */
#ifndef RSH_SHADE_MIRROR_H
#define RSH_SHADE_MIRROR_H

#include "shade/departure.h"

/* The interpolated normal at the point; zero or not finite: that of the triangle. */
static twofold3 smooth_normal_at(const surface_buffers* buffers, const surface_hit* surface,
                                 uint triangle, const departure* from)
{
    const twofold3 from_v0 = exact_sum3(from->point, -surface->triangle.v0);
    const float3 w = surface->edges.scale * (from_v0.high + (from_v0.low + from->rest));
    const float3 n = from->normal.high / dot3(from->normal.high, from->normal.high);
    const float u = dot3(cross3(w, surface->edges.edge2.high), n);
    const float v = dot3(cross3(surface->edges.edge1.high, w), n);
    uint corner[3];
    triangle_vertices(buffers->mesh, buffers->indices, triangle, corner);
    const float3 n0 = vertex_normal(buffers, corner[0]);
    const twofold3 normal = exact_sum3(n0, u * (vertex_normal(buffers, corner[1]) - n0) +
                                               v * (vertex_normal(buffers, corner[2]) - n0));
    const float size = largest3(fabs(normal.high));
    if (!(size > 0.0f) || !is_finite3(normal.high) || !is_finite3(normal.low))
        return from->normal;
    return twofold_scaled(scale_to_one(size), normal);
}

/* d - 2 (d.n) / (n.n) n: the sides of n do not matter. */
static float3 mirrored(float3 d, twofold3 n)
{
    const twofold along = twofold_dot(twofold3_of(d), n);
    const twofold square = twofold_dot(n, n);
    const float share = 2.0f * along.high / square.high;
    const float rest = (fma(-share, square.high, 2.0f * along.high) +
                        (2.0f * along.low - share * square.low)) /
                       square.high;
    const twofold3 back = exact_product3((float3)(share), n.high);
    twofold3 direction = exact_sum3(d, -back.high);
    direction.low -= back.low + (share * n.low + rest * n.high);
    return twofold_unit(direction);
}

static float3 mirror_direction(const surface_buffers* buffers, const surface_hit* surface,
                               uint triangle, const departure* from)
{
#if RSH_SMOOTH_NORMAL
    return mirrored(from->direction, smooth_normal_at(buffers, surface, triangle, from));
#else
    return mirrored(from->direction, from->normal);
#endif
}

#endif
