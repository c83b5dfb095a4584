/* copy_hits.h - hits in a row to another place. */
#ifndef RSH_TRAVERSE_COPY_HITS_H
#define RSH_TRAVERSE_COPY_HITS_H

#include "lanes/lanes.h"
#include "rsh/rsh_types.h"
#include "tuning.h"

/* Defines a function that copies hits from memory of its own. capacity: of the list that they are of; a
 * large one goes past the caches. `to` may be the caller's memory, which need not be aligned. */
#define RSH_DEFINE_COPY_HITS(name, SPACE)                                              \
    static void name(SPACE const float4* from, uint count, ulong capacity,             \
                     __global rsh_hit* to)                                             \
    {                                                                                  \
        if (capacity >= RSH_LARGE_LIST && (ulong)to % 16 == 0)                         \
            for (uint i = 0; i < count; ++i)                                           \
                RSH_STORE_PAST_CACHES(from[i], (__global float4*)to + i);              \
        else                                                                           \
            for (uint i = 0; i < count; ++i) vstore4(from[i], i, (__global float*)to); \
    }

#endif
