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
 * parts, a work-item each; a part has room for the clusters that it may need, and for groups
 * that are above its clusters alone. */
typedef struct rsh_scene_shape {
    rsh_uint triangles;
    rsh_uint part; /* triangles in each part but the last; a multiple of 16 */
    rsh_uint parts;
    rsh_uint part_clusters;
    rsh_uint part_groups;
    rsh_uint upper_groups; /* above clusters of several parts */
} rsh_scene_shape;
RSH_ASSERT_SIZE(rsh_scene_shape, 24);

#define RSH_CLUSTERS(shape) ((shape).parts * (shape).part_clusters)
#define RSH_GROUPS(shape) ((shape).parts * (shape).part_groups + (shape).upper_groups)

/* Bits of rsh_box_group::below besides the number: it is that of a cluster, not of a group; the
 * cluster has triangles that intersect.h scales. */
#define RSH_IS_CLUSTER (1u << 26)
#define RSH_SCALED (1u << 27)

/* Where there is no box: any cluster. Rays that take a box which holds nothing for met, as they
 * may where the reciprocal of a direction is 0, find nothing there that they should not. */
#define RSH_NO_BOX (1u << 25 | RSH_IS_CLUSTER | RSH_SCALED)

#define RSH_BELOW_NUMBER(below) ((below) & 0x01ffffffu)

/* Words before the parts of it that are neither clusters nor groups, and before the order of a
 * list's rays in its nodes; see rsh_levels. */
#define RSH_ORDER_AT(shape)                          \
    (sizeof(rsh_cluster) / 4 * RSH_CLUSTERS(shape) + \
     sizeof(rsh_box_group) / 4 * RSH_GROUPS(shape))
#define RSH_SURVEYS_AT(shape) (RSH_ORDER_AT(shape) + (shape).triangles)
#define RSH_TOP_AT(shape) (RSH_SURVEYS_AT(shape) + RSH_SURVEYS * sizeof(rsh_survey) / 4)
#define RSH_COUNTS_AT(shape) (RSH_TOP_AT(shape) + sizeof(rsh_scene_top) / 4)
#define RSH_BOUND_WORDS(shape) \
    (RSH_COUNTS_AT(shape) + (shape).parts * sizeof(rsh_part_counts) / 4)
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

/* Numbers of groups, each behind those that are in it: the last is the topmost. */
typedef struct rsh_group_range {
    rsh_uint first, end;
} rsh_group_range;
RSH_ASSERT_SIZE(rsh_group_range, 8);

/* Groups above clusters of several parts. */
typedef struct rsh_scene_top {
    rsh_group_range groups;
    rsh_uint triangles; /* as many as the scene has, once bounds were made of it */
} rsh_scene_top;
RSH_ASSERT_SIZE(rsh_scene_top, 12);

/* Of a part. */
typedef struct rsh_part_counts {
    rsh_uint clusters;
    rsh_group_range groups;
} rsh_part_counts;
RSH_ASSERT_SIZE(rsh_part_counts, 12);

/* A box around a cluster or a group, and how it is named in the group that it is in. */
typedef struct rsh_loose_box {
    rsh_float side[6]; /* low x y z, high x y z */
    rsh_uint below;
} rsh_loose_box;
RSH_ASSERT_SIZE(rsh_loose_box, 28);

/* Two boxes and the one around them; see tree_boxes.h. */
typedef struct rsh_box_branch {
    rsh_float side[6];
    rsh_uint below[2];
    rsh_uint clusters;
    rsh_uint shares[4];  /* a byte for each number of slots: those of the first; 0: a group */
    rsh_uint group, next; /* of what waits to be a group: its number; another that waits */
    rsh_uint unused; /* a cache line each */
} rsh_box_branch;
RSH_ASSERT_SIZE(rsh_box_branch, 64);

/* The highest branches, or clusters, of a part; and the branches that wait to be groups. */
#define RSH_PART_TOPS 4
#define RSH_NO_BRANCH 0xffffffffu
typedef struct rsh_tree_part {
    rsh_uint top[RSH_PART_TOPS];
    rsh_uint tops;
    rsh_uint waiting;     /* RSH_NO_BRANCH: none */
    rsh_uint first_group; /* the lowest number taken by now */
} rsh_tree_part;
RSH_ASSERT_SIZE(rsh_tree_part, 28);

/* The tree while it grows: branches of the parts, then those above; what they cost; parts; and
 * words for rsh_tops, part by part, then for what is above them. */
#define RSH_BRANCHES(shape) (RSH_CLUSTERS(shape) + RSH_PART_TOPS * (shape).parts)
#define RSH_LEAST_AT(shape) (sizeof(rsh_box_branch) / 4 * RSH_BRANCHES(shape))
#define RSH_TREE_PARTS_AT(shape) (RSH_LEAST_AT(shape) + 16 * RSH_BRANCHES(shape))
#define RSH_TOPS_AT(shape) \
    (RSH_TREE_PARTS_AT(shape) + sizeof(rsh_tree_part) / 4 * ((shape).parts + 1))
#define RSH_TOPS_MARGIN 48
#define RSH_TOPS_WORDS(room) (8 * ((room) + RSH_TOPS_MARGIN))
#define RSH_TREE_WORDS(shape)                                                      \
    (RSH_TOPS_AT(shape) + (shape).parts * RSH_TOPS_WORDS((shape).part_clusters) + \
     RSH_TOPS_WORDS(RSH_PART_TOPS * (shape).parts))

/* Groups that are in one another, at most: a round of grow_tree.h puts at most one branch on
 * another. A part of 588 clusters takes 12 rounds and 8 that halve what is left, the parts of
 * 2^28 triangles 12 and 17. */
#define RSH_MAX_BOX_DEPTH 50

/* Bins of order_triangles.cl, by cells of 2^-bits of the scene: cells for large triangles, four
 * times as long, then those for the others. */
#define RSH_ORDER_BINS(bits) (65u << (3 * (bits) - 6))

/* Bins of sort_rays.cl: octants of directions by cells of origins; then inactive rays. */
#define RSH_RAY_CELL_BITS 3
#define RSH_RAY_BINS ((8u << (3 * RSH_RAY_CELL_BITS)) + 1)

#endif
