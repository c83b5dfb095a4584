/* types.h - what bounds a scene, as it lies in memory; shared by host and device. */
#ifndef RSH_BVH_TYPES_H
#define RSH_BVH_TYPES_H

#include "rsh/rsh_types.h"

/* Up to sixteen triangles side by side, [corner][axis][triangle]; with corners at infinity:
 * none, or one that is never hit. */
typedef struct bvh_leaf {
    rsh_float corner[3][3][16];
    rsh_uint triangle[16]; /* their numbers; RSH_NO_HIT: none */
} bvh_leaf;
RSH_ASSERT_SIZE(bvh_leaf, 640);

/* Up to sixteen boxes side by side, around leaves and around other nodes. [axis][box]. A box
 * that holds nothing has low = infinity, high = -infinity. */
typedef struct bvh_node {
    rsh_float low[3][16];
    rsh_float high[3][16];
    rsh_uint child[16]; /* its number, and which of them: see bvh/types.h */
} bvh_node;
RSH_ASSERT_SIZE(bvh_node, 448);

/* What rsh_bound makes for the bound `box`, see bvh/layout.h: triangles in their order come in
 * parts, a work-item each; a part has room for the leaves that it may need, and for nodes
 * that are above its leaves alone. */
typedef struct bvh_layout {
    rsh_uint triangles;
    rsh_uint part; /* triangles in each part but the last; a multiple of 16 */
    rsh_uint parts;
    rsh_uint part_leaves;
    rsh_uint part_nodes;
    rsh_uint upper_nodes; /* above leaves of several parts */
} bvh_layout;
RSH_ASSERT_SIZE(bvh_layout, 24);

#define RSH_LEAVES(layout) ((layout).parts * (layout).part_leaves)
#define RSH_NODES(layout) ((layout).parts * (layout).part_nodes + (layout).upper_nodes)

/* Bits of bvh_node::child besides the number: it is that of a leaf, not of a node; the
 * leaf has triangles that mesh/intersect.h scales. */
#define RSH_IS_LEAF (1u << 26)
#define RSH_SCALED (1u << 27)

/* Where there is no box: any leaf. Rays that take a box which holds nothing for met, as they
 * may where the reciprocal of a direction is 0, find nothing there that they should not. */
#define RSH_NO_CHILD (1u << 25 | RSH_IS_LEAF | RSH_SCALED)

#define RSH_CHILD_NUMBER(child) ((child)&0x01ffffffu)

/* Words before the parts of it that are neither leaves nor nodes. */
#define RSH_ORDER_AT(layout)                                            \
    (sizeof(bvh_head) / 4 + sizeof(bvh_leaf) / 4 * RSH_LEAVES(layout) + \
     sizeof(bvh_node) / 4 * RSH_NODES(layout))
#define RSH_QUALITY_AT(layout) (RSH_ORDER_AT(layout) + (layout).triangles)
#define RSH_PARTS_AT(layout) \
    (RSH_QUALITY_AT(layout) + RSH_QUALITY_SAMPLES * sizeof(refit_quality) / 4)
#define RSH_BVH_WORDS(layout) (RSH_PARTS_AT(layout) + (layout).parts * sizeof(bvh_part) / 4)
/* Surfaces of boxes at a place of an order of triangles, added up: around triangles, around
 * leaves, and around all of that place; see bvh/refit_quality.h. */
#define RSH_QUALITY_SAMPLES 20
#define RSH_QUALITY_SAMPLES_PER_STEP 4
typedef struct refit_quality {
    rsh_float triangles, leaves, range;
} refit_quality;
RSH_ASSERT_SIZE(refit_quality, 12);

/* Numbers of nodes, each behind those that are in it: the last is the topmost. */
typedef struct node_range {
    rsh_uint first, end;
} node_range;
RSH_ASSERT_SIZE(node_range, 8);

/* What bounds hold, said at their start: all else lies where the shape puts it. */
typedef struct bvh_head {
    rsh_uint made; /* RSH_BVH_MADE: all of it is there; any other word: nothing is */
    bvh_layout layout;
    node_range nodes;   /* above leaves of several parts */
    rsh_uint unused[7]; /* leaves begin at a cache line */
} bvh_head;
RSH_ASSERT_SIZE(bvh_head, 64);

#define RSH_BVH_MADE 0x62687372u

/* The same for spheres. */
typedef struct spheres_head {
    rsh_uint made; /* RSH_SPHERES_MADE */
    rsh_uint triangles;
    rsh_uint unused[14]; /* spheres begin at a cache line */
} spheres_head;
RSH_ASSERT_SIZE(spheres_head, 64);

#define RSH_SPHERES_MADE 0x73687372u

/* Of a part. */
typedef struct bvh_part {
    rsh_uint leaves;
    node_range nodes;
} bvh_part;
RSH_ASSERT_SIZE(bvh_part, 12);

/* A box around a leaf or a node, and how it is named in the node that it is in. */
typedef struct child_box {
    rsh_float side[6]; /* low x y z, high x y z */
    rsh_uint child;
} child_box;
RSH_ASSERT_SIZE(child_box, 28);

/* Two boxes and the one around them; see bvh/binary_tree.h. */
typedef struct tree_branch {
    rsh_float side[6];
    rsh_uint child[2];
    rsh_uint leaves;
    rsh_uint slot_split[4]; /* a byte for each number of slots: those of the first; 0: a node */
    rsh_uint node, next;    /* of what waits to be a node: its number; another that waits */
    rsh_uint unused;        /* a cache line each */
} tree_branch;
RSH_ASSERT_SIZE(tree_branch, 64);

/* The highest branches, or leaves, of a part; and the branches that wait to be nodes. */
#define RSH_PART_ROOTS 4
#define RSH_NO_BRANCH 0xffffffffu
typedef struct tree_part {
    rsh_uint root[RSH_PART_ROOTS];
    rsh_uint roots;
    rsh_uint waiting;    /* RSH_NO_BRANCH: none */
    rsh_uint first_node; /* the lowest number taken by now */
} tree_part;
RSH_ASSERT_SIZE(tree_part, 28);

/* The tree while it grows: branches of the parts, then those above; what they cost; parts; and
 * words for active_nodes, part by part, then for what is above them. */
#define RSH_BRANCHES(layout) (RSH_LEAVES(layout) + RSH_PART_ROOTS * (layout).parts)
#define RSH_LEAST_COST_AT(layout) (sizeof(tree_branch) / 4 * RSH_BRANCHES(layout))
#define RSH_TREE_PARTS_AT(layout) (RSH_LEAST_COST_AT(layout) + 16 * RSH_BRANCHES(layout))
#define RSH_ACTIVE_AT(layout) \
    (RSH_TREE_PARTS_AT(layout) + sizeof(tree_part) / 4 * ((layout).parts + 1))
#define RSH_ACTIVE_MARGIN 48
#define RSH_ACTIVE_WORDS(room) (8 * ((room) + RSH_ACTIVE_MARGIN))
#define RSH_TREE_WORDS(layout)                                                         \
    (RSH_ACTIVE_AT(layout) + (layout).parts * RSH_ACTIVE_WORDS((layout).part_leaves) + \
     RSH_ACTIVE_WORDS(RSH_PART_ROOTS * (layout).parts))

/* Nodes that are in one another, at most: a round of bvh/ploc.h puts at most one branch on
 * another. A part of 588 leaves takes 12 rounds and 8 that halve what is left, the parts of
 * 2^28 triangles 12 and 17. */
#define RSH_MAX_BVH_DEPTH 50

/* Bins of bvh/order.cl, by cells of 2^-bits of the scene: cells for large triangles, four
 * times as long, then those for the others. */
#define RSH_ORDER_BINS(bits) (65u << (3 * (bits)-6))

#endif
