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

/* Boxes of a scene: level 1 those around the clusters, runs of 16 triangles; level l + 1 those
 * around the groups of 16 of level l; the topmost level is one group. 2^28 triangles fill 7
 * levels, that of the triangles counted. */
#define RSH_MAX_BOX_LEVELS 7
typedef struct rsh_box_levels {
    rsh_uint count;
    rsh_uint boxes[RSH_MAX_BOX_LEVELS];       /* [0]: triangles */
    rsh_uint first_group[RSH_MAX_BOX_LEVELS]; /* [0]: unused */
    rsh_uint group_count;                     /* of all levels */
} rsh_box_levels;
RSH_ASSERT_SIZE(rsh_box_levels, 64);

/* Words before the order of triangles, and before its surveys, in what rsh_bound makes for the
 * bound `box`, and before the order of a list's rays in its nodes; see scene_boxes.h and
 * rsh_levels. */
#define RSH_ORDER_AT(levels)                                  \
    (sizeof(rsh_cluster) / 4 * (levels).boxes[1] +            \
     sizeof(rsh_box_group) / 4 * (levels).group_count)
#define RSH_SURVEYS_AT(levels) \
    (RSH_ORDER_AT(levels) + (levels).boxes[0] + ((levels).boxes[1] + 15) / 16)
#define RSH_RAY_ORDER_AT(tiles) (sizeof(rsh_node_group) / 4 * (tiles))

/* One level of a traversal by runs: nodes of level + 1, each with a run of triangles, hand them
 * on to their children at `level`. */
typedef struct rsh_run_step {
    rsh_uint level;
    rsh_uint parents;     /* nodes of level + 1 */
    rsh_uint pieces;      /* that a parent's run is cut into, a work-item each */
    rsh_uint first_group; /* the children of parent i are group first_group + i */
    rsh_uint first_parent_run, first_child_run; /* of node 0 */
    rsh_uint capacity;    /* of the stream, in triangles */
    rsh_uint is_root;     /* 1: the only parent's run is the batch, and stored nowhere */
    rsh_uint batch_first, batch_count; /* triangles */
    rsh_uint is_counting; /* 1: a tally is wanted */
} rsh_run_step;
RSH_ASSERT_SIZE(rsh_run_step, 44);

/* Words that such a batch leaves for the statistics: [level] pairs in the stream of the level,
 * [RSH_TALLY_SURVIVORS + level] those that there should have been, [RSH_TALLY_FINISHED] tests
 * of triangles against a tile's blocks by rsh_finish_runs, [... + 1] against rays. */
#define RSH_TALLY_SURVIVORS 17
#define RSH_TALLY_FINISHED 34
#define RSH_TALLY_WORDS 36

/* How sort.cl puts things in the order of their keys: by bins, key >> rest, and in a bin by the
 * other bits; decided on the device. */
typedef struct rsh_sorting {
    rsh_uint is_needed; /* 0: they stay as they are, and have no keys */
    rsh_uint rest;      /* bits */
} rsh_sorting;
RSH_ASSERT_SIZE(rsh_sorting, 8);

/* What a work-item saw of the scene, or of a list of rays, before they are sorted. */
typedef struct rsh_span {
    rsh_float low[3], high[3];
    rsh_uint asked, sparse; /* runs of 16; those that are no neighbours */
} rsh_span;
RSH_ASSERT_SIZE(rsh_span, 32);

/* Surfaces of boxes at a place of an order of triangles, added up: around triangles, around
 * clusters, and around all of that place; see order_survey.h. */
#define RSH_SURVEYS 20
#define RSH_SURVEYS_PER_STEP 4
typedef struct rsh_survey {
    rsh_float triangles, clusters, run;
} rsh_survey;
RSH_ASSERT_SIZE(rsh_survey, 12);

/* Bins of order_triangles.cl, by cells of 2^-bits of the scene: cells for large triangles, four
 * times as long, then those for the others. */
#define RSH_ORDER_BINS(bits) (65u << (3 * (bits) - 6))

/* Bins of sort_rays.cl: octants of directions by cells of origins; then inactive rays. */
#define RSH_RAY_CELL_BITS 3
#define RSH_RAY_BINS ((8u << (3 * RSH_RAY_CELL_BITS)) + 1)

#endif
