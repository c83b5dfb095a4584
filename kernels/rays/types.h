/* types.h - nodes over the rays as they lie in memory; shared by host and device. */
#ifndef RSH_RAYS_TYPES_H
#define RSH_RAYS_TYPES_H

#include "rsh/rsh_types.h"

/* Four sibling nodes, component by component. A node bounds the rays that start inside a
 * sphere and leave inside a cone (Roger et al. 2007):
 *   apex_*   centre of the sphere [world]
 *   radius   of the sphere [world]; negative: the node holds no active ray
 *   axis_*   unit axis of the cone
 *   sine     of the cone's half-angle; 2: the cone is the whole space of directions */
typedef struct cone_node4 {
    rsh_float4 apex_x, apex_y, apex_z, radius;
    rsh_float4 axis_x, axis_y, axis_z, sine;
} cone_node4;
RSH_ASSERT_SIZE(cone_node4, 128);

/* Sixteen sibling nodes of the bound `box`: the blocks of a tile. [axis][block]. */
typedef struct box_node16 {
    rsh_float origin_low[3][16];
    rsh_float origin_high[3][16];
    rsh_float direction_low[3][16];
    rsh_float direction_high[3][16];
    rsh_float tmax[16];         /* of the farthest ray; -1: the node holds no active ray */
    rsh_uint is_converging[16]; /* 1: seen from t = 1, backwards; see rsh_build_desc */
} box_node16;
RSH_ASSERT_SIZE(box_node16, 896);

/* Words before the order of a list's rays in its nodes; see rsh_levels. */
#define RSH_RAY_ORDER_AT(tiles) (sizeof(box_node16) / 4 * (tiles))

/* Bins of rays/sort_rays.cl: octants of directions by cells of origins; then inactive rays. */
#define RSH_RAY_CELL_BITS 3
#define RSH_RAY_BINS ((8u << (3 * RSH_RAY_CELL_BITS)) + 1)

#endif
