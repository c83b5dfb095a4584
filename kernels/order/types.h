/* types.h - what sorting keeps on the device; shared by host and device. */
#ifndef RSH_ORDER_TYPES_H
#define RSH_ORDER_TYPES_H

#include "rsh/rsh_types.h"

/* How order/sort.cl puts things in the order of their keys: by bins, key >> bin_shift, and in a bin by the
 * other bits; decided on the device. */
typedef struct sort_plan {
    rsh_uint is_needed; /* 0: they stay as they are, and have no keys */
    rsh_uint bin_shift; /* bits */
} sort_plan;
RSH_ASSERT_SIZE(sort_plan, 8);

/* What a work-item saw of the scene, or of a list of rays, before they are sorted. */
typedef struct sample_bounds {
    rsh_float low[3], high[3];
    rsh_uint sampled, incoherent; /* ranges of 16; those that are no neighbours */
} sample_bounds;
RSH_ASSERT_SIZE(sample_bounds, 32);

#endif
