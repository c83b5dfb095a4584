/* wrong_buffers.h - a traversal looks at what its bounds and nodes say of themselves, and tells
 * when they are not what it was called with; see "Opaque" in rsh.h. */
#ifndef RSH_TRAVERSE_WRONG_BUFFERS_H
#define RSH_TRAVERSE_WRONG_BUFFERS_H

#include "rsh/rsh_types.h"

/* Whether the traversal may go on. wrong: a word, bits RSH_WRONG_... are added to it. */
static bool are_right(bool bounds_are, bool nodes_are, volatile __global uint* wrong)
{
    const uint bits = (bounds_are ? 0 : RSH_WRONG_BOUNDS) | (nodes_are ? 0 : RSH_WRONG_NODES);
    if (bits && (*wrong & bits) != bits) atomic_or(wrong, bits);
    return !bits;
}

#endif
