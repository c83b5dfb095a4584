/* types.h - what bounds a scene, as it lies in memory; shared by host and device. */
#ifndef RSH_BVH_TYPES_H
#define RSH_BVH_TYPES_H

#include "rsh/rsh_types.h"

/* Up to sixteen triangles side by side, [corner][axis][triangle]; with corners at infinity:
 * none, or one that is never hit. */
typedef struct rsh_cluster {
    rsh_float corner[3][3][16];
    rsh_uint triangle[16]; /* their numbers; RSH_NO_HIT: none */
} rsh_cluster;
RSH_ASSERT_SIZE(rsh_cluster, 640);

/* Up to sixteen boxes side by side, around clusters and around other groups. [axis][box]. A box
 * that holds nothing has low = infinity, high = -infinity. */
typedef struct rsh_box_group {
    rsh_float low[3][16];
    rsh_float high[3][16];
    rsh_uint below[16]; /* its number, and which of them: see kernels/kernel_types.h */
} rsh_box_group;
RSH_ASSERT_SIZE(rsh_box_group, 448);

/* What rsh_bound makes for the bound `box`, see bvh/layout.h: triangles in their order come in
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
 * cluster has triangles that mesh/intersect.h scales. */
#define RSH_IS_CLUSTER (1u << 26)
#define RSH_SCALED (1u << 27)

/* Where there is no box: any cluster. Rays that take a box which holds nothing for met, as they
 * may where the reciprocal of a direction is 0, find nothing there that they should not. */
#define RSH_NO_BOX (1u << 25 | RSH_IS_CLUSTER | RSH_SCALED)

#define RSH_BELOW_NUMBER(below) (0x01ffffffu & (below))

/* Words before the parts of it that are neither clusters nor groups. */
#define RSH_ORDER_AT(shape)                                                        \
    (sizeof(rsh_bounds_head) / 4 + sizeof(rsh_cluster) / 4 * RSH_CLUSTERS(shape) + \
     sizeof(rsh_box_group) / 4 * RSH_GROUPS(shape))
#define RSH_SURVEYS_AT(shape) (RSH_ORDER_AT(shape) + (shape).triangles)
#define RSH_COUNTS_AT(shape) (RSH_SURVEYS_AT(shape) + RSH_SURVEYS * sizeof(rsh_survey) / 4)
#define RSH_BOUND_WORDS(shape) \
    (RSH_COUNTS_AT(shape) + (shape).parts * sizeof(rsh_part_counts) / 4)
/* Surfaces of boxes at a place of an order of triangles, added up: around triangles, around
 * clusters, and around all of that place; see bvh/refit_quality.h. */
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

/* What bounds hold, said at their start: all else lies where the shape puts it. */
typedef struct rsh_bounds_head {
    rsh_uint made; /* RSH_BOUNDS_MADE: all of it is there; any other word: nothing is */
    rsh_scene_shape shape;
    rsh_group_range groups; /* above clusters of several parts */
    rsh_uint unused[7];     /* clusters begin at a cache line */
} rsh_bounds_head;
RSH_ASSERT_SIZE(rsh_bounds_head, 64);

#define RSH_BOUNDS_MADE 0x62687372u

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

/* Two boxes and the one around them; see bvh/binary_tree.h. */
typedef struct rsh_box_branch {
    rsh_float side[6];
    rsh_uint below[2];
    rsh_uint clusters;
    rsh_uint shares[4];   /* a byte for each number of slots: those of the first; 0: a group */
    rsh_uint group, next; /* of what waits to be a group: its number; another that waits */
    rsh_uint unused;      /* a cache line each */
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
#define RSH_TREE_WORDS(shape)                                                     \
    (RSH_TOPS_AT(shape) + (shape).parts * RSH_TOPS_WORDS((shape).part_clusters) + \
     RSH_TOPS_WORDS(RSH_PART_TOPS * (shape).parts))

/* Groups that are in one another, at most: a round of bvh/ploc.h puts at most one branch on
 * another. A part of 588 clusters takes 12 rounds and 8 that halve what is left, the parts of
 * 2^28 triangles 12 and 17. */
#define RSH_MAX_BOX_DEPTH 50

/* Bins of bvh/order.cl, by cells of 2^-bits of the scene: cells for large triangles, four
 * times as long, then those for the others. */
#define RSH_ORDER_BINS(bits) ((1u << 3 * (bits)) / 64 * 65)

#endif
