/* mirror.h - the direction of a mirrored ray, rounded once: in a chain of curved mirrors every
 * error grows from bounce to bounce. */
#ifndef RSH_SHADE_MIRROR_H
#define RSH_SHADE_MIRROR_H

#include "shade/departure.h"

/* The share that `part` has of `whole`, of normals of the same plane, by its largest component. */
static twofold share_of(twofold3 part, twofold3 whole)
{
    const float3 size = fabs(whole.high);
    if (size.x >= size.y && size.x >= size.z)
        return twofold_quotient((twofold){part.high.x, part.low.x},
                                (twofold){whole.high.x, whole.low.x});
    if (size.y >= size.z)
        return twofold_quotient((twofold){part.high.y, part.low.y},
                                (twofold){whole.high.y, whole.low.y});
    return twofold_quotient((twofold){part.high.z, part.low.z},
                            (twofold){whole.high.z, whole.low.z});
}

/* The interpolated normal at the point; zero or not finite: that of the triangle. In floats, its
 * error would be as large as that of the direction's rounding. */
static twofold3 smooth_normal_at(const surface_buffers* buffers, const surface_hit* surface,
                                 uint triangle, const departure* from)
{
    const twofold3 from_v0 = exact_sum3(from->point, -surface->triangle.v0);
    const twofold3 w =
        twofold_scaled(surface->edges.scale, gathered(from_v0.high, from_v0.low + from->rest));
    const twofold u = share_of(twofold_cross(w, surface->edges.edge2), from->normal);
    const twofold v = share_of(twofold_cross(surface->edges.edge1, w), from->normal);
    uint corner[3];
    triangle_vertices(buffers->mesh, buffers->indices, triangle, corner);
    const float3 n0 = vertex_normal(buffers, corner[0]);
    const twofold3 to_n1 = exact_sum3(vertex_normal(buffers, corner[1]), -n0);
    const twofold3 to_n2 = exact_sum3(vertex_normal(buffers, corner[2]), -n0);
    const twofold3 normal = twofold_sum3(
        twofold3_of(n0), twofold_sum3(twofold_times(u, to_n1), twofold_times(v, to_n2)));
    const float size = largest3(fabs(normal.high));
    if (!(size > 0.0f) || !is_finite3(normal.high) || !is_finite3(normal.low))
        return from->normal;
    return twofold_scaled(scale_to_one(size), normal);
}

/* d - 2 (d.n) / (n.n) n: the sides of n do not matter. */
static float3 mirrored(float3 d, twofold3 n)
{
    const twofold share = twofold_quotient(twofold_dot(twofold3_of(d), n), twofold_dot(n, n));
    const twofold3 back = twofold_times((twofold){-2.0f * share.high, -2.0f * share.low}, n);
    return twofold_unit(twofold_sum3(twofold3_of(d), back));
}

static float3 mirror_direction(const surface_buffers* buffers, const surface_hit* surface,
                               uint triangle, const departure* from)
{
    const twofold3 normal =
        RSH_SMOOTH_NORMAL ? smooth_normal_at(buffers, surface, triangle, from) : from->normal;
    return mirrored(from->direction, normal);
}

#endif
