/* types.h - what host and device call a part of a wave of rays. */
#ifndef RSH_SHADE_TYPES_H
#define RSH_SHADE_TYPES_H

#include "rsh/rsh_types.h"

/* Side of the squares in which a screen's rays are taken, see shade/screen_order.h; a power of 2. */
#define RSH_SCREEN_SQUARE 64

/* Places `first` to `first` + `count` of a wave: of a packed one, of height 1, its rays; of a screen
 * its squares, row by row. */
typedef struct wave_part {
    rsh_uint width, height;
    rsh_uint first, count;
} wave_part;
RSH_ASSERT_SIZE(wave_part, 16);

/* Kinds of rays that a hit sends on; in a set of kinds the bits 1 << kind. */
enum { RSH_REFLECTED = 0, RSH_REFRACTED = 1, RSH_BRANCHES = 2 };

#endif
