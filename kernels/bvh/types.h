/* types.h - a scene's BVH as it lies in memory: leaves of 16 triangles, nodes of 16 children,
 * and what is needed to build and refit them. Triangles that stand still and those that move
 * have a tree each, so that only the latter is refitted; a node above both makes them one BVH.
 * Shared by host and device; bvh/layout.h finds things.
 */
#ifndef RSH_BVH_TYPES_H
#define RSH_BVH_TYPES_H

#include "rsh/rsh_types.h"

/* Up to 16 triangles side by side, [corner][axis][triangle], their corners in order. Where there
 * is no triangle, or one that is never hit, its corners are at infinity. */
typedef struct bvh_leaf {
    rsh_float corner[3][3][16];
    rsh_uint triangle[16]; /* of each, index and places; RSH_NO_HIT: none */
} bvh_leaf;
RSH_ASSERT_SIZE(bvh_leaf, 640);

/* Of bvh_leaf::triangle: the index, below 2^28; above it, where the caller's corners went
 * (mesh/corner_order.h). */
#define RSH_TRIANGLE_INDEX(word) (0x0fffffffu & (word))
#define RSH_PLACES_SHIFT 28
#define RSH_TRIANGLE_PLACES(word) ((word) >> RSH_PLACES_SHIFT)

/* Up to 16 children side by side, leaves or other nodes, and their boxes, [axis][child]. The
 * box of an empty slot has low = infinity, high = -infinity. */
typedef struct bvh_node {
    rsh_float low[3][16];
    rsh_float high[3][16];
    rsh_uint child[16]; /* RSH_CHILD_NUMBER and bits, see below */
} bvh_node;
RSH_ASSERT_SIZE(bvh_node, 448);

/* The trees of a scene: of the triangles that stand still, rsh_geometry::still_triangles from
 * the first one on, and of those that move, all others. Either may have none. */
enum bvh_tree { RSH_STILL_TREE, RSH_MOVING_TREE, RSH_TREES };

/* Both trees together. Where both have triangles, the last node is above them. */
typedef struct bvh_whole {
    rsh_uint triangles, still_triangles;
    rsh_uint leaves, nodes; /* room for them */
} bvh_whole;
RSH_ASSERT_SIZE(bvh_whole, 16);

/* Where things lie in one of the trees. The triangles, in their order along the curve, are cut
 * into parts, a work-item each. A part has room for as many leaves as it may need, and for the
 * nodes above them. Leaves and nodes are numbered through both trees. */
typedef struct bvh_layout {
    bvh_whole whole;
    rsh_uint tree;      /* RSH_..._TREE */
    rsh_uint triangles; /* of this tree */
    rsh_uint part;      /* triangles in each part but the last; a multiple of 16 */
    rsh_uint parts;
    rsh_uint part_leaves; /* room for leaves in a part */
    rsh_uint part_nodes;  /* room for nodes in a part */
    rsh_uint upper_nodes; /* room for nodes above leaves of several parts */
    rsh_uint first_leaf, first_node;
    rsh_uint words_before; /* of the other tree, behind all leaves and nodes */
} bvh_layout;
RSH_ASSERT_SIZE(bvh_layout, 56);

/* Of one tree. */
#define RSH_LEAVES(layout) ((layout).parts * (layout).part_leaves)
#define RSH_NODES(layout) ((layout).parts * (layout).part_nodes + (layout).upper_nodes)
#define RSH_FIRST_TRIANGLE(layout) \
    ((layout).tree == RSH_MOVING_TREE ? (layout).whole.still_triangles : 0)

/* Bits of bvh_node::child besides the number. RSH_IS_LEAF: the number is a leaf's, not a
 * node's. RSH_SCALED: some triangle of the leaf is of a size that mesh/intersect.h scales. */
#define RSH_IS_LEAF (1u << 26)
#define RSH_SCALED (1u << 27)

/* An empty slot; its number is that of leaf 0. A ray may enter the slot when 1 / direction = 0
 * lets the slab test pass; testing leaf 0 once more is harmless. Bit 25 tells it from leaf 0
 * itself. */
#define RSH_NO_CHILD (1u << 25 | RSH_IS_LEAF | RSH_SCALED)

#define RSH_CHILD_NUMBER(child) (0x01ffffffu & (child))

/* First words of what a tree has behind the leaves and the nodes. */
#define RSH_ORDER_AT(layout)                                               \
    (sizeof(bvh_head) / 4 + sizeof(bvh_leaf) / 4 * (layout).whole.leaves + \
     sizeof(bvh_node) / 4 * (layout).whole.nodes + (layout).words_before)
#define RSH_QUALITY_AT(layout) (RSH_ORDER_AT(layout) + (layout).triangles)
#define RSH_PARTS_AT(layout) \
    (RSH_QUALITY_AT(layout) + RSH_QUALITY_SAMPLES * sizeof(refit_quality) / 4)
#define RSH_TREE_END(layout) (RSH_PARTS_AT(layout) + (layout).parts * sizeof(bvh_part) / 4)

/* How compact the order of triangles is at one place of it, which takes 16 ranges of 16
 * triangles: the surface of the triangles' boxes, of the ranges' boxes, and of the box around
 * all; see bvh/refit_quality.h. */
#define RSH_QUALITY_SAMPLES 20
#define RSH_QUALITY_SAMPLES_PER_STEP 4
typedef struct refit_quality {
    rsh_float triangles, leaves, range;
} refit_quality;
RSH_ASSERT_SIZE(refit_quality, 12);

/* What bvh/order.cl does when it is launched, in this order. */
enum order_pass {
    RSH_QUALITY_PASS, /* of a refit: how compact is the order that the BVH holds? */
    RSH_SAMPLE_PASS, /* where is the scene, and does it get a new order? The keys follow if so, */
    RSH_KEYS_PASS,
    RSH_RECORD_PASS /* and, when triangles are sorted, how compact the new order is */
};

/* What bvh/nodes.cl does with the binary tree when it is launched, in this order. */
enum tree_pass {
    RSH_GROW_PASS, /* a work-item each grows the tree of a part, */
    RSH_TOP_PASS,  /* one the tree above the parts, whose nodes it makes, */
    RSH_NODES_PASS /* and one each makes the nodes of a part */
};

/* Consecutive nodes, each behind its children: the last is the topmost. */
typedef struct node_range {
    rsh_uint first, end;
} node_range;
RSH_ASSERT_SIZE(node_range, 8);

/* What the buffer holds, said at its start: all else lies where the layout puts it. */
typedef struct bvh_head {
    rsh_uint made[RSH_TREES]; /* RSH_BVH_MADE: the tree is there; any other word: it is not */
    rsh_uint joined;          /* the same of the node above both trees */
    bvh_whole whole;          /* what both trees were made of */
    node_range nodes[RSH_TREES]; /* above leaves of several parts */
    rsh_uint unused[5];          /* leaves begin at a cache line */
} bvh_head;
RSH_ASSERT_SIZE(bvh_head, 64);

#define RSH_BVH_MADE 0x62687372u

/* What the buffer holds where spheres are around the triangles (bvh/spheres.cl). */
typedef struct spheres_head {
    rsh_uint made; /* RSH_SPHERES_MADE */
    rsh_uint triangles;
    rsh_uint unused[14]; /* spheres begin at a cache line */
} spheres_head;
RSH_ASSERT_SIZE(spheres_head, 64);

#define RSH_SPHERES_MADE 0x73687372u

/* What a part made of its room. */
typedef struct bvh_part {
    rsh_uint leaves;
    node_range nodes;
} bvh_part;
RSH_ASSERT_SIZE(bvh_part, 12);

/* The box of a leaf or a node, and how its parent is to name it (bvh_node::child). */
typedef struct child_box {
    rsh_float side[6]; /* low x y z, high x y z */
    rsh_uint child;
} child_box;
RSH_ASSERT_SIZE(child_box, 28);

/* A node of the binary tree; see bvh/binary_tree.h. */
typedef struct tree_branch {
    rsh_float side[6];
    rsh_uint child[2];
    rsh_uint leaves;
    rsh_uint slot_split[4]; /* 16 bytes: of k slots, how many the first child has; 0: none of
                               them, the branch becomes a node of its own in one slot */
    rsh_uint node, next;    /* while it waits to become a node: that node; next that waits */
    rsh_uint unused;        /* up to a cache line */
} tree_branch;
RSH_ASSERT_SIZE(tree_branch, 64);

/* The binary tree of a part: its topmost branches or leaves, and the branches that wait to
 * become nodes. */
#define RSH_PART_ROOTS 4
#define RSH_NO_BRANCH 0xffffffffu
typedef struct tree_part {
    rsh_uint root[RSH_PART_ROOTS];
    rsh_uint roots;
    rsh_uint waiting;    /* RSH_NO_BRANCH: none */
    rsh_uint first_node; /* nodes are numbered downwards: the last number that was given */
} tree_part;
RSH_ASSERT_SIZE(tree_part, 28);

/* Memory of the binary tree while it grows: branches of the parts, then those above; what each
 * costs in 1 .. 16 slots; tree_part of each part, then of what is above; words for active_nodes
 * of each part, then of what is above. */
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

/* Depth of the tree, at most: a round of bvh/ploc.h makes it one branch deeper, and a node is
 * at least one branch. A part of 588 leaves takes RSH_NEAREST_ROUNDS = 12 rounds, then 8 that
 * halve what is left; the 4 roots of each part of 2^28 triangles take 12 and 17; the node above
 * both trees: 50. */
#define RSH_MAX_BVH_DEPTH 50

/* Bins of bvh/order.cl, a cell each: first the cells of large triangles, four times as long, so
 * a 64th as many; then 2^bits along each axis for the others. */
#define RSH_ORDER_BINS(bits) ((1u << 3 * (bits)) / 64 * 65)

#endif
