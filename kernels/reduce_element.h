/* reduce_element.h - elements of 4, 8, 12 or 16 bytes and the question whether to keep one.
 *   RSH_WORDS  words of 4 bytes per element: 1 .. 4
 *   RSH_FLAGS  1: a byte per element says so; 0: the first word is not RSH_NO_HIT
 */
#ifndef RSH_REDUCE_ELEMENT_H
#define RSH_REDUCE_ELEMENT_H

#include "rsh_types.h"

#ifndef RSH_WORDS
#define RSH_WORDS 2
#endif
#ifndef RSH_FLAGS
#define RSH_FLAGS 0
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

static uint is_kept(__global const uint* input, __global const uchar* flags, uint i)
{
#if RSH_FLAGS
    return flags[i] != 0;
#else
    return input[(ulong)RSH_WORDS * i] != RSH_NO_HIT;
#endif
}

/* Elements in the stream: on the device, or what the host said. */
static uint stream_length(__global const uint* input_count, uint has_input_count, uint count)
{
    return has_input_count ? min(*input_count, count) : count;
}

#endif
