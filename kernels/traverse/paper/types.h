/* types.h - steps of a traversal by ranges; shared by host and device. */
#ifndef RSH_TRAVERSE_PAPER_TYPES_H
#define RSH_TRAVERSE_PAPER_TYPES_H

#include "rsh/rsh_types.h"

/* A parent's range is cut so that each level has work-items for all cores; each of them looks at
 * the counts of all slices of its parent, so that more slices would cost more than they bring. */
#define RSH_MAX_SLICES 256

/* One level of a traversal by ranges: nodes of level + 1, each with a range of triangles, hand
 * these on to their children at `level`. */
typedef struct range_step {
    rsh_uint level;
    rsh_uint parents;           /* nodes of level + 1 */
    rsh_uint slices;            /* that a parent's range is cut into, a work-item each */
    rsh_uint first_child_group; /* the children of parent i are number first_child_group + i */
    rsh_uint first_parent_range, first_child_range; /* numbers of the ranges of node 0 */
    rsh_uint capacity;                              /* of the stream, in triangles */
    rsh_uint is_root; /* 1: the only parent's range is the batch, and stored nowhere */
    rsh_uint batch_first, batch_count; /* triangles */
    rsh_uint is_counting;              /* 1: a tally is wanted */
} range_step;
RSH_ASSERT_SIZE(range_step, 44);

/* Words that such a batch leaves for the statistics: [level] pairs in the stream of the level,
 * [RSH_TALLY_SURVIVORS + level] those that there should have been, [RSH_TALLY_FINISHED] tests
 * of triangles against a tile's blocks by rsh_intersect_ranges_finish, [... + 2] against rays;
 * these two as traverse/count.h has them; [RSH_TALLY_ROOT] the level of the root, 0 if there are
 * no rays. */
#define RSH_TALLY_SURVIVORS 17
#define RSH_TALLY_FINISHED 34
#define RSH_TALLY_ROOT 38
#define RSH_TALLY_WORDS 39

#endif
