/* types.h - what sorting keeps on the device; shared by host and device. */
#ifndef RSH_ORDER_TYPES_H
#define RSH_ORDER_TYPES_H

#include "rsh/rsh_types.h"

/* How order/sort.cl puts things in the order of their keys: by bins, key >> rest, and in a bin by the
 * other bits; decided on the device. */
typedef struct rsh_sorting {
    rsh_uint is_needed; /* 0: they stay as they are, and have no keys */
    rsh_uint rest;      /* bits */
} rsh_sorting;
RSH_ASSERT_SIZE(rsh_sorting, 8);

/* What a work-item saw of the scene, or of a list of rays, before they are sorted. */
typedef struct rsh_span {
    rsh_float low[3], high[3];
    rsh_uint asked, sparse; /* runs of 16; those that are no neighbours */
} rsh_span;
RSH_ASSERT_SIZE(rsh_span, 32);

#endif
