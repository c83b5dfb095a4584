/* kernel_types.h - structs passed by value to kernels, written once for host and device. Not
 * API. */
#ifndef RSH_KERNEL_TYPES_H
#define RSH_KERNEL_TYPES_H

#include "rsh_types.h"

/* How to read rsh_geometry: offsets and stride in words of 4 bytes. */
typedef struct rsh_mesh {
    rsh_uint vertices_first_low, vertices_first_high;
    rsh_uint indices_first_low, indices_first_high;
    rsh_uint vertex_stride;
    rsh_uint vertex_count;
    rsh_uint triangle_count;
    rsh_uint is_indexed;
} rsh_mesh;
RSH_ASSERT_SIZE(rsh_mesh, 32);

/* Boxes of a scene: level 0 those of triangles, level l + 1 those around the groups of 16 of
 * level l; the topmost level, 1 at least, is one group. 2^28 triangles fill 7 levels. */
#define RSH_MAX_BOX_LEVELS 7
typedef struct rsh_box_levels {
    rsh_uint count;
    rsh_uint boxes[RSH_MAX_BOX_LEVELS];
    rsh_uint first_group[RSH_MAX_BOX_LEVELS];
    rsh_uint group_count; /* of all levels */
} rsh_box_levels;
RSH_ASSERT_SIZE(rsh_box_levels, 64);

#endif
