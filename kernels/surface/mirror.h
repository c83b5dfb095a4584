/* mirror.h - the directions of mirrored rays, rounded once: in a chain of curved mirrors every
 * error grows from bounce to bounce. */
#ifndef RSH_SURFACE_MIRROR_H
#define RSH_SURFACE_MIRROR_H

#include "surface/departure.h"

/* The share that `part` has of `whole`, of normals of the same plane, by its largest component. */
static twofoldv share_of(twofold3v part, twofold3v whole)
{
    const float3v size = fabs_v(whole.high);
    const intv by_x = (size.x >= size.y) & (size.x >= size.z), by_y = size.y >= size.z;
#define PICKED(v) select(select((v).z, (v).y, by_y), (v).x, by_x)
    return twofold_quotient_v((twofoldv){PICKED(part.high), PICKED(part.low)},
                              (twofoldv){PICKED(whole.high), PICKED(whole.low)});
#undef PICKED
}

/* The interpolated normals at the points; zero or not finite: those of the triangles. In floats,
 * their errors would be as large as that of the direction's rounding. */
static twofold3v smooth_normals_at(const surface_lanes* surface, const departure_lanes* from)
{
    const twofold3v from_v0 = exact_sum3_v(from->point, opposite_v(surface->v0));
    const twofold3v w = twofold_scaled_v(
        surface->edges.scale, gathered_v(from_v0.high, sum_v(from_v0.low, from->rest)));
    const twofoldv u = share_of(twofold_cross_v(w, surface->edges.edge2), from->normal);
    const twofoldv v = share_of(twofold_cross_v(surface->edges.edge1, w), from->normal);
    const float3v n0 = surface->vertex_normals[0], from_n0 = opposite_v(n0);
    const twofold3v to_n1 = exact_sum3_v(surface->vertex_normals[1], from_n0);
    const twofold3v to_n2 = exact_sum3_v(surface->vertex_normals[2], from_n0);
    const twofold3v sum =
        twofold_sum3_v(twofold3_of_v(n0),
                       twofold_sum3_v(twofold_times_v(u, to_n1), twofold_times_v(v, to_n2)));
    const floatv size = largest_v(fabs_v(sum.high));
    const twofold3v normal = twofold_scaled_v(scale_to_one_v(size), sum);
    const intv is_normal =
        (size > (floatv)(0.0f)) & is_finite_v(sum.high) & is_finite_v(sum.low);
    return (twofold3v){select_v(from->normal.high, normal.high, is_normal),
                       select_v(from->normal.low, normal.low, is_normal)};
}

/* d - 2 (d.n) / (n.n) n: the sides of n do not matter. */
static float3v mirrored(float3v d, twofold3v n)
{
    const twofoldv share =
        twofold_quotient_v(twofold_dot_v(twofold3_of_v(d), n), twofold_dot_v(n, n));
    const twofold3v back =
        twofold_times_v((twofoldv){-2.0f * share.high, -2.0f * share.low}, n);
    return twofold_unit_v(twofold_sum3_v(twofold3_of_v(d), back));
}

static float3v mirror_directions(const surface_lanes* surface, const departure_lanes* from)
{
    return mirrored(from->direction, has_smooth_normals(surface->features)
                                         ? smooth_normals_at(surface, from)
                                         : from->normal);
}

#endif
