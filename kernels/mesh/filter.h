/* filter.h - which hits a ray does not see, in programs that are made for that (RSH_FILTER): those with
 * meshes whose mask has no bit in common with the ray's, and those of triangles that turn the side to it
 * that is culled. In other programs nothing is left of it.
 *
 * A side is told by the signs that decide about the hit: what closest hits, counts and lists call a front
 * is one for all engines, and along a ray through a closed surface fronts and backs of all its crossings
 * take turns.
 */
#ifndef RSH_MESH_FILTER_H
#define RSH_MESH_FILTER_H

#ifndef RSH_FILTER
#define RSH_FILTER 0
#endif

#if RSH_FILTER
#define RSH_MESH_RANGES
#endif
#include "mesh/mesh_ranges.h"

#if RSH_FILTER

typedef struct hit_filter {
    __global const uint* ray_masks; /* 0: masks hide nothing */
    __global const rsh_mesh_range* ranges;
    uint range_count; /* 0: one mesh, its mask all ones */
    uint cull;        /* RSH_CULLED_... */
} hit_filter;

/* At the end of a kernel's parameters, and of a triangles_left. */
#define RSH_FILTER_PARAMETERS                                                     \
    , __global const uint *ray_masks, __global const rsh_mesh_range *mesh_ranges, \
        uint mesh_range_count, uint cull
#define RSH_GIVEN_FILTER \
    , { ray_masks, mesh_ranges, mesh_range_count, cull }

/* Places of corners 1 and 2 (mesh/corner_order.h) where the three were turned, not reversed: a bit
 * for each. */
#define RSH_PLACES_TURNED 0x214u

/* Whether a ray sees a triangle's corners clockwise, in the caller's order. is_negative: the area of the
 * corners in order, in the ray's space, whose x and y are seen clockwise along z. */
static bool is_seen_clockwise(bool is_negative, bool is_backward, uint places)
{
    return is_negative ^ is_backward ^ !(RSH_PLACES_TURNED >> places & 1);
}

static bool is_unseen(const hit_filter* filter, uint ray, uint triangle, bool is_clockwise)
{
    if (filter->cull == (is_clockwise ? RSH_CULLED_BACK : RSH_CULLED_FRONT)) return true;
    if (!filter->ray_masks) return false;
    const uint mask =
        filter->range_count
            ? filter->ranges[range_of(filter->ranges, filter->range_count, triangle)].mask
            : 0xffffffffu;
    return (filter->ray_masks[ray] & mask) == 0;
}

#else
#define RSH_FILTER_PARAMETERS
#define RSH_GIVEN_FILTER
#endif

#endif
