/* element.h - elements of 4, 8, 12 or 16 bytes and the question whether to keep one.
 *   RSH_WORDS  words of 4 bytes per element: 1 .. 4
 *   RSH_KEEP   as RSH_KEEP_... of rsh.h; 0: a byte per element says so, 1: the first word is
 *              not RSH_NO_HIT, 2: a bit per element says so
 */
#ifndef RSH_REDUCE_ELEMENT_H
#define RSH_REDUCE_ELEMENT_H

#include "rsh/rsh_types.h"

#ifndef RSH_WORDS
#define RSH_WORDS 2
#endif
#ifndef RSH_KEEP
#define RSH_KEEP 1
#endif

#if RSH_WORDS == 1
typedef uint element;
#define load_element(i, from) ((from)[i])
#define store_element(value, i, to) ((to)[i] = (value))
#elif RSH_WORDS == 2
typedef uint2 element;
#define load_element(i, from) vload2(i, from)
#define store_element(value, i, to) vstore2(value, i, to)
#elif RSH_WORDS == 3
typedef uint3 element;
#define load_element(i, from) vload3(i, from)
#define store_element(value, i, to) vstore3(value, i, to)
#else
typedef uint4 element;
#define load_element(i, from) vload4(i, from)
#define store_element(value, i, to) vstore4(value, i, to)
#endif

#define RSH_MAYBE_UNUSED __attribute__((unused))
/* The first arguments of every kernel of a strategy, whether it reads them or not. */
#define RSH_STREAM                                                                             \
    RSH_MAYBE_UNUSED __global const uint *input, RSH_MAYBE_UNUSED __global const uchar *flags, \
        RSH_MAYBE_UNUSED __global const uint *input_count,                                     \
        RSH_MAYBE_UNUSED uint has_input_count, RSH_MAYBE_UNUSED uint count

/* Elements in the stream: on the device, or what the host said. */
#define RSH_LENGTH (has_input_count ? min(*input_count, count) : count)

static uint is_kept(__global const uint* input, __global const uchar* flags, uint i)
{
    if (RSH_KEEP == 0) return flags[i] != 0;
    if (RSH_KEEP == 1) return input[(ulong)RSH_WORDS * i] != RSH_NO_HIT;
    return flags[i / 8] >> (i % 8) & 1;
}

#endif
