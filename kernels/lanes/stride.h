/* stride.h - divides a stream among the work-items that were launched: its length is only known
 * on the device. On SIMT devices (RSH_WIDTH 1) neighbouring work-items take neighbouring
 * elements; elsewhere each takes a range of its own, which suits a CPU's caches.
 */
#ifndef RSH_LANES_STRIDE_H
#define RSH_LANES_STRIDE_H

#include "lanes/lanes.h"

typedef struct strided_range {
    uint begin, end, step;
} strided_range;

/* Of `count` elements, a range for this work-item; these are in the order of the work-items. */
static strided_range my_range(uint count)
{
    const uint items = get_global_size(0), me = get_global_id(0);
    const uint per_item = count / items + (count % items != 0);
    const uint begin = min(count, (uint)min((ulong)per_item * me, (ulong)count));
    return (strided_range){begin, begin + min(per_item, count - begin), 1};
}

/* Of `count` elements, those of this work-item, in any order. */
static strided_range my_elements(uint count)
{
    if (RSH_WIDTH == 1) return (strided_range){get_global_id(0), count, get_global_size(0)};
    return my_range(count);
}

/* Of `count` elements, where the share of a work-item begins, if each has the same: on CPUs,
 * neighbouring work-items often share a core, and of a launch for more than there are, each core shall
 * have its part. */
static uint share_begin(uint count, ulong item)
{
    return (uint)(item * count / get_global_size(0));
}

/* Of `count` elements, no more than there are work-items, that of this one; `count`: none. On CPUs
 * those of the two halves in turn, as costs change along a list: sorted rays end with those that are
 * inactive. */
static uint my_element(uint count)
{
    const ulong me = get_global_id(0);
    if (RSH_WIDTH == 1) return (uint)min(me, (ulong)count);
    const uint share = share_begin(count, me);
    if (share == share_begin(count, me + 1)) return count;
    return share % 2 ? (count + 1) / 2 + share / 2 : share / 2;
}

/* Of `count` elements, those of this work-item, in any order, in blocks of RSH_WIDTH: all of them full
 * but the last one. */
static strided_range my_blocks(uint count)
{
    if (RSH_WIDTH == 1) return my_elements(count);
    const uint blocks = (count + RSH_WIDTH - 1) / RSH_WIDTH;
    const ulong me = get_global_id(0);
    return (strided_range){RSH_WIDTH * share_begin(blocks, me),
                           min(RSH_WIDTH * share_begin(blocks, me + 1), count), 1};
}

#endif
