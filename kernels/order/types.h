/* types.h - what sorting keeps on the device; shared by host and device. */
#ifndef RSH_ORDER_TYPES_H
#define RSH_ORDER_TYPES_H

#include "rsh/rsh_types.h"

/* How order/sort.cl sorts: into bins, key >> bin_shift, then each bin by the lower bits.
 * Decided on the device. */
typedef struct sort_plan {
    rsh_uint is_needed; /* 0: elements stay as they are, and have no keys */
    rsh_uint bin_shift; /* 0: bins are not sorted themselves */
    rsh_uint count;     /* elements */
    rsh_uint items;     /* work-items that share them, the first of those launched */
} sort_plan;
RSH_ASSERT_SIZE(sort_plan, 16);

/* Work-items that may share so many elements: no more bins than elements, but for four. */
#define RSH_SORT_ITEMS(count, bins) ((count) / (bins) > 4 ? (count) / (bins) : 4)

/* What a work-item sampled of the scene, or of a list of rays, before they are sorted. */
typedef struct sample_bounds {
    rsh_float low[3], high[3];
    rsh_uint sampled, incoherent; /* groups of 16; those whose elements are no neighbours */
} sample_bounds;
RSH_ASSERT_SIZE(sample_bounds, 32);

#endif
