/* types.h - steps of a traversal by runs; shared by host and device. */
#ifndef RSH_TRAVERSE_PAPER_TYPES_H
#define RSH_TRAVERSE_PAPER_TYPES_H

#include "rsh/rsh_types.h"

/* One level of a traversal by runs: nodes of level + 1, each with a run of triangles, hand them
 * on to their children at `level`. */
typedef struct rsh_run_step {
    rsh_uint level;
    rsh_uint parents;     /* nodes of level + 1 */
    rsh_uint pieces;      /* that a parent's run is cut into, a work-item each */
    rsh_uint first_group; /* the children of parent i are group first_group + i */
    rsh_uint first_parent_run, first_child_run; /* of node 0 */
    rsh_uint capacity;                          /* of the stream, in triangles */
    rsh_uint is_root; /* 1: the only parent's run is the batch, and stored nowhere */
    rsh_uint batch_first, batch_count; /* triangles */
    rsh_uint is_counting;              /* 1: a tally is wanted */
} rsh_run_step;
RSH_ASSERT_SIZE(rsh_run_step, 44);

/* Words that such a batch leaves for the statistics: [level] pairs in the stream of the level,
 * [RSH_TALLY_SURVIVORS + level] those that there should have been, [RSH_TALLY_FINISHED] tests
 * of triangles against a tile's blocks by rsh_finish_runs, [... + 1] against rays. */
#define RSH_TALLY_SURVIVORS 17
#define RSH_TALLY_FINISHED 34
#define RSH_TALLY_WORDS 36

#endif
