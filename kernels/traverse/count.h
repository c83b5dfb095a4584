/* count.h - counts for the statistics: 64 bits in two words, the lower first. OpenCL C 1.2 adds
 * 32 bits at a time; a large image makes more tests than that in a launch. */
#ifndef RSH_TRAVERSE_COUNT_H
#define RSH_TRAVERSE_COUNT_H

static void add_to_count(__global uint* count, ulong more)
{
    const uint low = (uint)more, before = atomic_add(count, low);
    const uint high = (uint)(more >> 32) + (before + low < before);
    if (high) atomic_add(count + 1, high);
}

#endif
