/* stride.h - spreads a stream over however many work-items were launched: the stream's length
 * is only known on the device. Neighbouring work-items take neighbouring elements on SIMT
 * devices (RSH_WIDTH 1); elsewhere each takes a run of its own, which a CPU's caches prefer. */
#ifndef RSH_LANES_STRIDE_H
#define RSH_LANES_STRIDE_H

#include "lanes/lanes.h"

typedef struct rsh_stride {
    uint begin, end, step;
} rsh_stride;

/* Of `count` elements, those of this work-item. */
static rsh_stride my_elements(uint count)
{
    const uint items = get_global_size(0), me = get_global_id(0);
    if (RSH_WIDTH == 1) return (rsh_stride){me, count, items};
    const uint run = count / items + (count % items != 0);
    const uint begin = min(count, (uint)min((ulong)run * me, (ulong)count));
    return (rsh_stride){begin, begin + min(run, count - begin), 1};
}

#endif
