/* mesh_ranges.h - which mesh a triangle is of, see rsh_mesh_range; for programs that define
 * RSH_MESH_RANGES. In others nothing is left of it. */
#ifndef RSH_MESH_MESH_RANGES_H
#define RSH_MESH_MESH_RANGES_H

#include "mesh/types.h"

#ifdef RSH_MESH_RANGES

/* The last range that begins at the triangle or before it; if they do not ascend, any one of them.
 * range_count: at least 1. */
static uint range_of(__global const rsh_mesh_range* ranges, uint range_count, uint triangle)
{
    uint first = 0, count = range_count;
    while (count > 1) {
        const uint front = count / 2;
        if (ranges[first + front].first_triangle <= triangle) {
            first += front;
            count -= front;
        } else {
            count = front;
        }
    }
    return first;
}

#endif

#endif
