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

#endif
