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

/* Sixteen sibling nodes of shape `box`, such as the blocks of a tile. [axis][node]. */
typedef struct box_node16 {
    rsh_float origin_low[3][16];
    rsh_float origin_high[3][16];
    rsh_float direction_low[3][16];
    rsh_float direction_high[3][16];
    rsh_float tmax[16]; /* of the farthest ray; -1: the node holds no active ray */
    rsh_uint
        is_converging[16]; /* 1: the rays are seen from t = 1, backwards; see rsh_build_desc */
} box_node16;
RSH_ASSERT_SIZE(box_node16, 896);

/* What nodes say of themselves at their start. */
typedef struct nodes_head {
    rsh_uint made; /* RSH_CONES_MADE or RSH_BOXES_MADE; any other word: they are none */
    rsh_uint width, height, is_list; /* of their rays' places */
    rsh_uint counted;                /* rays in a row that there are, see counted_levels */
    rsh_uint
        order_at; /* word where the order of a list's rays begins, see ray_levels; 0: none */
    rsh_uint unused[10]; /* nodes begin at a cache line */
} nodes_head;
RSH_ASSERT_SIZE(nodes_head, 64);

#define RSH_CONES_MADE 0x6e687372u
#define RSH_BOXES_MADE 0x6f687372u

/* Of a block of a list, before it is sorted. */
typedef struct block_extent {
    rsh_float origins; /* longest side of the box around them */
    rsh_uint is_wide;  /* whether the directions differ much */
} block_extent;
RSH_ASSERT_SIZE(block_extent, 8);

/* Shape of a hierarchy over width x height rays. One row or one column counts as a list.
 *
 * Level 0 holds the rays. A node of level l + 1 has branching * branching children of level l:
 * node (x, y) those from (branching * x, branching * y) on, row by row; in a list, a range of
 * branching * branching. A node's index is y * width[l] + x; children outside of the level are
 * inactive.
 *
 * cone: branching 2, level `count` is the root; the children of a node are one cone_node4,
 * number
 *       first_child_group[l] + index.
 * box:  branching 4, level 1 are blocks, level 2 tiles, and that is all; the children of a tile
 * are
 *       one box_node16, number index. Behind those of a list lies a word per ray. If the list is
 *       sorted, the words are the rays in their order, and children mean places in it. */
typedef struct ray_levels {
    rsh_uint count;
    rsh_uint is_list; /* 1: every level has height 1, children in a row */
    rsh_uint width[RSH_MAX_LEVELS + 1];
    rsh_uint height[RSH_MAX_LEVELS + 1];
    rsh_uint first_child_group[RSH_MAX_LEVELS +
                               1]; /* of the nodes of level l; [count]: all of them */
    rsh_uint branching;
} ray_levels;
RSH_ASSERT_SIZE(ray_levels, 216);

/* Where an rsh_ray_floats lies in its buffer, in words of 4 bytes. */
typedef struct ray_floats_view {
    rsh_uint first_low, first_high;
    rsh_uint stride;
    rsh_uint reserved;
} ray_floats_view;
RSH_ASSERT_SIZE(ray_floats_view, 16);

/* Words before the order of a list's rays in its nodes; see ray_levels. */
#define RSH_RAY_ORDER_AT(tiles) (sizeof(nodes_head) / 4 + sizeof(box_node16) / 4 * (tiles))

/* Bins of rays/sort_rays.cl: octants of directions by cells of origins; then inactive rays. */
#define RSH_RAY_CELL_BITS 3
#define RSH_RAY_BINS ((8u << (3 * RSH_RAY_CELL_BITS)) + 1)

#endif
