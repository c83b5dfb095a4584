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

/* What rsh_bound makes for the bound `box`, see scene_boxes.h: triangles in their order come in
 * parts, a work-item each; a part has room for the clusters and groups that it may need. */
typedef struct rsh_scene_shape {
    rsh_uint triangles;
    rsh_uint part; /* triangles in each part but the last; a multiple of 16 */
    rsh_uint parts;
    rsh_uint part_clusters;
    rsh_uint part_groups;  /* of clusters */
    rsh_uint upper_groups; /* of groups, of all levels together */
} rsh_scene_shape;
RSH_ASSERT_SIZE(rsh_scene_shape, 24);

#define RSH_CLUSTERS(shape) ((shape).parts * (shape).part_clusters)
#define RSH_GROUPS(shape) ((shape).parts * (shape).part_groups + (shape).upper_groups)

/* Levels of boxes: clusters, groups, groups of groups. Runs of 8 and more leave 2^28 triangles
 * that many. */
#define RSH_MAX_BOX_LEVELS 9

/* In rsh_box_group::below, of a cluster: it has triangles that intersect.h scales. */
#define RSH_SCALED (1u << 27)

/* Words before the parts of it that are neither clusters nor groups, and before the order of a
 * list's rays in its nodes; see rsh_levels. */
#define RSH_ORDER_AT(shape)                          \
    (sizeof(rsh_cluster) / 4 * RSH_CLUSTERS(shape) + \
     sizeof(rsh_box_group) / 4 * RSH_GROUPS(shape))
#define RSH_SURVEYS_AT(shape) (RSH_ORDER_AT(shape) + (shape).triangles)
#define RSH_TOP_AT(shape) (RSH_SURVEYS_AT(shape) + RSH_SURVEYS * sizeof(rsh_survey) / 4)
#define RSH_COUNTS_AT(shape) (RSH_TOP_AT(shape) + sizeof(rsh_scene_top) / 4)
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

/* The group that all others are below, and what its boxes are around: 1: clusters. */
typedef struct rsh_scene_top {
    rsh_uint group, level;
    rsh_uint triangles; /* as many as the scene has, once bounds were made of it */
} rsh_scene_top;
RSH_ASSERT_SIZE(rsh_scene_top, 12);

/* A box that waits for a group to be in: around a cluster or a group, by number. */
typedef struct rsh_loose_box {
    rsh_float side[6]; /* low x y z, high x y z */
    rsh_uint below;
} rsh_loose_box;
RSH_ASSERT_SIZE(rsh_loose_box, 28);

/* Bins of order_triangles.cl, by cells of 2^-bits of the scene: cells for large triangles, four
 * times as long, then those for the others. */
#define RSH_ORDER_BINS(bits) (65u << (3 * (bits) - 6))

/* Bins of sort_rays.cl: octants of directions by cells of origins; then inactive rays. */
#define RSH_RAY_CELL_BITS 3
#define RSH_RAY_BINS ((8u << (3 * RSH_RAY_CELL_BITS)) + 1)

#endif
