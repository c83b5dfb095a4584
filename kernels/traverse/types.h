/* types.h - hits on their way into lists; shared by host and device. */
#ifndef RSH_TRAVERSE_TYPES_H
#define RSH_TRAVERSE_TYPES_H

#include "rsh/rsh_types.h"

/* A hit, and where it belongs: as number `rank` among the hits of its ray, which are not sorted
 * yet. ray = RSH_NO_HIT: the record is empty. */
typedef struct hit_record {
    rsh_hit hit;
    rsh_uint ray, rank;
} hit_record;
RSH_ASSERT_SIZE(hit_record, 24);

/* What records begin with. */
typedef struct hit_records_head {
    rsh_uint
        used; /* records that were taken, more than there are if the room did not suffice */
    rsh_uint packed; /* hits that tiles have packed, see traverse/tiles/pack_hits.h */
    rsh_uint unused[4];
} hit_records_head;
RSH_ASSERT_SIZE(hit_records_head, 24);

/* Hits of a ray that a tile of rays keeps, sorts and packs itself. */
#define RSH_HIT_ROWS 8

/* Records that a work-item takes at a time, where it has the hits of many rays. */
#define RSH_RECORDS_AT_ONCE 64

#endif
