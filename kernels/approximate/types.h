/* types.h - which pixels of an approximate frame are traced, shared by host and device. Not API.
 *
 * A grid has every pixel whose column and row are multiples of a step. A cell is the square from one of
 * them to the next, whose corners are that pixel and those to the right, below, and across. Half-way
 * between are the pixels beside it: in its row, in its column, and in the middle of the cell, which the
 * grid of half the step has as well. Rows are taken in bands, whose cells know nothing of the next band: so
 * it does not matter which bands are rendered together. */
#ifndef RSH_APPROXIMATE_TYPES_H
#define RSH_APPROXIMATE_TYPES_H

#include "rsh/rsh_types.h"

/* Of the screen. */
#define RSH_BAND_ROWS 64

/* Of the first grid, whose pixels are traced all; a power of 2. */
#define RSH_WIDEST_STEP 4

#define RSH_BESIDES 3

typedef struct pixel_grid {
    rsh_uint width, height; /* of the screen */
    rsh_uint step;
    rsh_uint columns, rows; /* of the grid   */
} pixel_grid;
RSH_ASSERT_SIZE(pixel_grid, 20);

#endif
