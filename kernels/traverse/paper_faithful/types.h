/* types.h - the stream of pairs; shared by host and device. */
#ifndef RSH_TRAVERSE_PAPER_FAITHFUL_TYPES_H
#define RSH_TRAVERSE_PAPER_FAITHFUL_TYPES_H

#include "rsh/rsh_types.h"

/* Element of the stream that the traversal works on. */
typedef struct stream_pair {
    rsh_uint triangle; /* RSH_NO_HIT: the pair did not survive */
    rsh_uint node;     /* grid: row * 65536 + column; list: the index; level 0: the ray */
} stream_pair;
RSH_ASSERT_SIZE(stream_pair, 8);

#endif
